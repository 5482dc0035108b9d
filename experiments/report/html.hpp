// Small parts of HTML text that the report's sections share.
#pragma once

#include <string>

namespace refitlab {

// A number by a printf pattern.
std::string format(const char* pattern, double value);

// Text as HTML: & < > and quotes escaped.
std::string escape_html(const std::string& text);

// RFC 4648, with padding.
std::string base64(const std::string& bytes);

}  // namespace refitlab
