// A table of contents for a page: its <h2> headings get ids, and links to them.
#pragma once

#include <string>

namespace refitlab {

struct Contents {
  std::string nav;   // a <nav> of links; empty if there are no headings
  std::string body;  // the page's, with ids
};

// body: HTML whose headings are plain <h2>TITLE</h2>, without attributes, and whose titles differ.
Contents contents_of(const std::string& body);

}  // namespace refitlab
