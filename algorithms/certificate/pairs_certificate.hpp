// SPDX-License-Identifier: GPL-3.0-or-later
// A certificate of pairs is a document that says which triangles of two posed characters have a point in common. Anyone can check
// it.
//
// It has the vertices and triangles of both bodies, a common point of each pair that touches, and planes that part all others.
// Every number is an exact fraction, as in certificate.hpp. proptests/certificate/check_pairs checks it, which shares no code
// with the library, and lemmas/proofs/checker/pairs.v, which is proved: an accepted certificate lists all pairs of triangles
// that meet, and no others. The claim is about the vertices in the document. They are the doubles that skinning and placing make,
// from which queries decide. It says nothing about exactly skinned vertices, of which other pairs may barely touch.
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
//   steps        "first": the first body's set is halved; "second": the second's; {normal: [x, y, z], offset}: the plane parts
//                the sets; or "contact": the sets are single triangles, which the next of the contacts is about (separation.hpp)
#pragma once

#include <string>
#include <vector>

#include "algorithms/certificate/certificate.hpp"
#include "algorithms/certificate/separation.hpp"

namespace refitlab {

// Returns a certificate that the listed triangles of the bodies meet, and no others. Their order does not matter.
// Throws NoProof if that is not so, and what separate() throws. It also throws NoProof for reasons with longer numbers than
// checkers read. Coordinates such as 10^-100 beside 1 may need these.
std::string pairs_certificate(const std::string& about, const PosedBody& first, const PosedBody& second,
                              std::vector<TrianglePair> pairs);

// Returns a body alone in the form that it has in a certificate. Certificates can be compared with this document.
std::string body_document(const PosedBody& body);

}  // namespace refitlab
