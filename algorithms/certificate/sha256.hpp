// SPDX-License-Identifier: GPL-3.0-or-later
// SHA-256 [FIPS 180-4] binds a certificate.
#pragma once

#include <string>
#include <string_view>

namespace refitlab {

// Returns 64 lower-case hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace refitlab
