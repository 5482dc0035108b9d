// SPDX-License-Identifier: GPL-3.0-or-later
// Some content of files is accepted only on request, because not every program can use it.
#pragma once

namespace refitlab {

// With `rigid`, skin matrices must be rotations, up to one constant scale; others are refused.
// With `affine`, any skin matrices are accepted. If they are not rigid as above, vertices and offset matrices are as the file has
// them, without a factor taken out of the skin matrices. Clip::sample then throws for a time whose pose is not rigid;
// skin_matrices gives the matrices.
enum class Joints { rigid, affine };

// With `constant`, the weights of morph targets stay as the file has them where no clip moves them, and the vertices are
// displaced accordingly; a file with a clip that moves them is refused.
// With `moving`, Model::morphs has the displacements and the constant weights, and the clips' animations have the others.
enum class Morphs { constant, moving };

struct LoadOptions {
  Joints joints = Joints::rigid;
  Morphs morphs = Morphs::constant;
};

}  // namespace refitlab
