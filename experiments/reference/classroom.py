# SPDX-License-Identifier: GPL-3.0-or-later
"""The plan of a class of two hours, the order of the other lemmas, and the pages that are of no lemma (their texts are in templates)."""

# Each entry has the time, the title, the explanation, and the lemmas' stems.
CLASS = [
    ("0:00", "The picture", "Look at the report's first pictures. Linear blending collapses; spherical blending does not. The spheres follow, and no vertex is "
     "touched. In the explorer, twist the waist of the man by 170 degrees on level 13 and choose variants.", []),
    ("0:15", "A cap and its ball: what breaks the algorithm", "Read the statement, then the erratum, then break a line. Everything else has the same form.",
     ["lemma5_cap_enclosing_sphere"]),
    ("0:40", "From quaternions to a cap", "Why a ball around a few quaternions bounds all of their blends.",
     ["lemma1_cap_definitions", "lemma3_sphere_surface_intersection", "lemma2_normalization", "lemma4_quaternion_hull"]),
    ("1:10", "From a cap of rotations to a ball of points", "The angle of the cap doubles. Beyond a certain angle only the whole sphere is a bound.",
     ["s43_rotated_cap", "s43_distance_range", "s43_whole_sphere_fallback"]),
    ("1:25", "Weights", "A box of weights, cut by the plane of sum 1, has weight vertices. Everything that is linear in the weights is in the hull of its values at them.",
     ["s41_weight_vertices_span", "s42_linear_part_hull", "s43_minkowski_sum"]),
    ("1:40", "Beyond the paper", "Blending is a rational Bezier simplex, so one hull of control points bounds the whole deformation.",
     ["b1_rational_bezier_simplex", "b2_control_hull_encloses"]),
    ("1:55", "An exercise to take home", "Plant an error of your own that is not in proptests/mutants/list.toml. Does a test die? If none does: is the error one that no test can see, or is a test missing?", []),
]

FURTHER = [
    ("All joint-sets of a node", ["s44_sum_of_bounds", "s44_joint_sets"]),
    ("Simplifications that are theorems", ["t3_min_dot_distance", "t3_one_cap", "t3_smallest_ball_smallest_cap", "rotation_bound"]),
    ("More beyond the paper", ["b3_subdivision", "b4_cap_fallback", "b5_rotation_axis", "b6_dual_quaternion_ball", "b7_motion_bound",
                          "b8_blend_error", "b9_pose_change", "b10_determinant_error"]),
    ("Bounds over time", ["c1_chord_bound", "c2_channel_motion", "c3_normalized_motion", "c4_chain_motion", "c5_skinned_motion", "c6_interval_hull", "c7_crossfade",
                          "c8_any_pose"]),
    ("Joints that scale, vertices that are displaced", ["a1_affine_image", "a2_two_phase_skinning", "a3_morph_displacement", "a4_joint_volumes"]),
]

# Each entry has the name of the template and of the page, and its title.
ROLES = [("programmer", "For the programmer: the refit in an engine"), ("researcher", "For the researcher: add a variant, a volume, a lemma"),
         ("rounding", "Rounding: from the reals to double"), ("errors", "Errors")]
