// The style sheet of the drawings, in a page's light or dark scheme. The page
// has --ink and --soft.
#pragma once

namespace refitlab::drawings {

inline constexpr const char *style =
    R"(:root{--blue:#0072b2;--orange:#b34700;--green:#00664a;--pink:#8f3f6b;--cap:#e69f00}
@media (prefers-color-scheme:dark){:root{--blue:#6fbbe8;--orange:#ff9a5c;--green:#4fd0a8;--pink:#e3a0c6;--cap:#f0b840}}
.drawing{width:100%;max-width:30rem;height:auto;display:block}.drawing text{fill:var(--ink);font:600 13px system-ui,sans-serif}
.drawing .line{stroke:var(--ink);fill:none}.drawing .surface{stroke:var(--soft);fill:none}
.drawing .ball{stroke:var(--blue);fill:var(--blue);fill-opacity:.12}
.drawing .printed{stroke:var(--orange);fill:var(--orange);fill-opacity:.1;stroke-dasharray:6 4}
.drawing .cap{stroke:var(--cap);fill:none;stroke-width:5}.drawing .plane{stroke:var(--green);stroke-width:2}
.drawing .outer{stroke:var(--ink);stroke-dasharray:6 4;fill:none}.drawing .hull{stroke:var(--ink);fill:var(--blue);fill-opacity:.1}
.drawing .dot{fill:var(--ink)}.drawing .dot_in{fill:var(--blue)}.drawing .dot_out{fill:var(--orange)}
.drawing .curve{stroke:var(--pink);fill:none;stroke-width:2.5}
)";

}  // namespace refitlab::drawings
