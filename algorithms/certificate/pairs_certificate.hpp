// SPDX-License-Identifier: GPL-3.0-or-later
// Certificate of pairs: which triangles of two posed characters have a point in common, as a document that anyone can check.
//
// It has the vertices and triangles of both bodies, a common point of each pair that touches, and planes that part all others.
// Every number is an exact fraction, as in certificate.hpp. proptests/certificate/check_pairs checks it, which shares no code
// with the library, and lemmas/proofs/checker/pairs.v, which is proved: an accepted certificate lists all pairs of triangles
// that meet, and no others. This is about the vertices as they stand there. They are the doubles that skinning and placing make,
// and that queries decide pairs of. How far they are from exactly skinned vertices is no part of the claim, as pairs that barely
// touch are others there.
//
// Format: JSON, its keys sorted, indented by one space, in ASCII, ended by a line feed:
//   about        what it is of, for the reader: no part of the claim
//   contacts     the claim, a list of {pair: [i, j], triangles of the first and of the second body; first, second: [u, v, w],
//                weights of their vertices, not negative, of sum 1, that make the same point}
//   digest       SHA-256 of the same text with "" for the digest
//   first, second
//                the bodies, {name, triangles: [[a, b, c]...], vertices: [[x, y, z]...]}
//   first_order, second_order
//                all triangles of the body, each once: sets of them are halved in this order
//   steps        "first": the first body's set is halved; "second": the second's; {normal: [x, y, z], offset}: the plane parts the
//                sets; or "contact": the sets are single triangles, which the next of the contacts is about (separation.hpp)
#pragma once

#include <string>
#include <vector>

#include "algorithms/certificate/certificate.hpp"
#include "algorithms/certificate/separation.hpp"

namespace refitlab {

// That those triangles of the bodies meet that are listed, in any order, and no others.
// Throws NoProof if that is not so, and what separate() throws; NoProof also for reasons with longer numbers than checkers read, which
// coordinates may need that are 10^-100 and 1.
std::string pairs_certificate(const std::string& about, const PosedBody& first, const PosedBody& second,
                              std::vector<TrianglePair> pairs);

// A body alone in the form that it has in a certificate: a document that certificates can be compared with.
std::string body_document(const PosedBody& body);

}  // namespace refitlab
