#include "experiments/report/contents.hpp"

#include <cctype>

namespace refitlab {
namespace {

std::string id_of(const std::string& title) {
  std::string id = "part";
  for (const unsigned char c : title)
    if (std::isalnum(c)) id += static_cast<char>(std::tolower(c));
    else if (id.back() != '-') id += '-';
  return id;
}

}  // namespace

Contents contents_of(const std::string& body) {
  const std::string open = "<h2>", close = "</h2>";
  Contents out;
  std::size_t at = 0;
  for (std::size_t next; (next = body.find(open, at)) != std::string::npos;) {
    const std::size_t from = next + open.size(), to = body.find(close, from);
    if (to == std::string::npos) break;
    const std::string title = body.substr(from, to - from), id = id_of(" " + title);
    out.body += body.substr(at, next - at) + "<h2 id=\"" + id + "\">" + title + close;
    out.nav += (out.nav.empty() ? "" : " · ") + ("<a href=\"#" + id + "\">" + title + "</a>");
    at = to + close.size();
  }
  out.body += body.substr(at);
  if (!out.nav.empty()) out.nav = "<nav aria-label=\"Contents\">" + out.nav + "</nav>\n";
  return out;
}

}  // namespace refitlab
