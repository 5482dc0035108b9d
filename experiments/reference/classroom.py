# SPDX-License-Identifier: GPL-3.0-or-later
"""These texts are not in the sources: the plan of a class of two hours, and the pages for the programmer and the researcher."""

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
                          "b8_blend_error"]),
    ("Bounds over time", ["c1_chord_bound", "c2_channel_motion", "c3_normalized_motion", "c4_chain_motion", "c5_skinned_motion", "c6_interval_hull", "c7_crossfade",
                          "c8_any_pose"]),
    ("Joints that scale, vertices that are displaced", ["a1_affine_image", "a2_two_phase_skinning", "a3_morph_displacement", "a4_joint_volumes"]),
]

PROGRAMMER = """
<section id="example"><h2>The refit in an engine</h2>
<p>The program loads a character once. Each frame has joint transforms. A query asks for the sphere of a node when it reaches the node.
The mesh is not skinned; only nodes of few vertices skin those. <code>experiments/run</code> compiles and runs this very file.</p>
[[include experiments/examples/engine_refit.cpp]]
<p>Build it in the repository, and run it:</p>
<pre><code>cmake --preset release
cmake --build build/release --target engine_refit
build/release/experiments/engine_refit</code></pre></section>
<section id="parts"><h2>What to change</h2><ul>
<li>The model: <code>algorithms/model/load.hpp</code> reads glTF, FBX, X and Collada; <code>algorithms/model/model.hpp</code> says what your own model must contain.</li>
<li>The skinning: <code>default_variant</code> names the refit to take for linear, spherical and dual quaternion blending (<code>algorithms/runtime/refit/variants.hpp</code>).</li>
<li>Many nodes of one frame: <code>algorithms/runtime/refit/frame_refits.hpp</code>; all nodes at once in SIMD: <code>algorithms/runtime/batch/batch_refit.hpp</code>.</li>
<li>Boxes, k-DOPs and oriented boxes in place of spheres: <code>algorithms/methods/refit/volume_variants.hpp</code> (they are compared, and not part of the runtime).</li>
<li>Which triangles of two characters touch: <code>algorithms/runtime/collide/cluster_collide.hpp</code>; of many: <code>algorithms/runtime/collide/crowd.hpp</code>.</li></ul></section>
"""

RESEARCHER = """
<section id="variant"><h2>Add a refit variant</h2><ol>
<li>A refit is a function of a <code>RefitNode</code> (<code>algorithms/runtime/tree/refit_node.hpp</code>). If it is new, write a template over the number type. Otherwise take a known
refit with another policy for its balls (<code>algorithms/runtime/refit/ball_policy.hpp</code>).</li>
<li>Add a row to the table in <code>algorithms/runtime/refit/variants.cpp</code>. For a proved bound, the row has the skinning, the function, a name, a description, and the pieces that it needs. The slack for rounding is added automatically. For example
<pre><code>sound&lt;spherical, control&lt;NearSmallestBalls&gt;&gt;("control_near", "control hull, near-smallest ball", P::node),</code></pre>
A bound that is not proved goes into <code>algorithms/methods/refit/compared_variants.cpp</code>, which is not shipped.</li>
<li>Add its name to <code>expected_variants</code> in <code>proptests/algorithms/variants.cpp</code>, too.</li>
<li><code>proptests/run --only refit_end_to_end synthetic_case</code>: every variant that the table calls sound must enclose every vertex of random rigs and of the models
(<code>proptests/algorithms/refit_end_to_end.cpp</code>). You need not write a test for that. <code>--only extremes certificate collide</code> tests the variants of the table too.</li>
<li><code>experiments/run --only tightness speed rounding</code>: the variant appears in the tables, the plots and the explorer automatically.</li>
<li>For a new template, write a suite that tests that intervals and exact numbers agree. <code>proptests/algorithms/control_hull.cpp</code> is an example.</li></ol></section>
<section id="volume"><h2>Add a volume</h2><ol>
<li>Write a class with <code>around(balls)</code>, which makes a convex volume that encloses the balls. <code>algorithms/methods/volumes/k_dop.hpp</code> and <code>algorithms/methods/volumes/obb.hpp</code> are examples.</li>
<li>Add it to the type <code>Volume</code> in <code>algorithms/methods/refit/volume_variants.hpp</code> and a row to the table in <code>algorithms/methods/refit/volume_variants.cpp</code>. A k-DOP of
another k needs only its directions. Update the number of volumes in <code>proptests/algorithms/volume_refit.cpp</code>.</li>
<li><code>proptests/run --only volume_refit</code> checks every row against skinned vertices; a new class gets a suite with its own stem, as in <code>proptests/algorithms/obb.cpp</code>.</li>
<li><code>experiments/run --only volumes</code> measures it.</li></ol></section>
<section id="lemma"><h2>Add a lemma</h2><ol>
<li><code>lemmas/lemma5_cap_enclosing_sphere.hpp</code> shows the order: statement, hypotheses as predicates, conclusion with a witness, a check of the witness that does not
call the solver, erratum, sources. Everything is a template over the number type. Verdicts are combined with <code>&amp;</code>.</li>
<li>Write its pinned cases in a file of the same stem, like <code>proptests/counterexamples/lemma5_cap_enclosing_sphere.hpp</code>.</li>
<li>Write its suite in a file of the same stem, like <code>proptests/lemmas/lemma5_cap_enclosing_sphere.cpp</code>, with <code>PROPTEST(stem)</code>. The suite tests that the lemma holds exactly, that intervals never
contradict it, and that a mutated witness is rejected. It has an example for each hypothesis that is dropped.</li>
<li>Run <code>proptests/run --only STEM</code>. Then a full <code>proptests/run --update-readme</code> puts the lemma into the verdict table.</li>
<li>Add two or three mutants to <code>proptests/mutants/list.toml</code>, and run <code>proptests/mutants/run --only STEM</code>.</li>
<li>Add the lemma to the class in <code>experiments/reference/classroom.py</code>, and a picture of it to <code>experiments/drawings</code>. Its page is then made automatically. The
reference cannot be built until both are there.</li></ol></section>
<section id="report"><h2>Show a new quantity in the report</h2><ol>
<li>The experiment writes the quantity into its table in <code>out/results</code>, one row for each value. The columns say what the row belongs to. Anything else that a reader needs to know
gets a column of its own. A new table gets a schema in <code>experiments/report/tables.py</code>, with its columns and the values that each may hold.</li>
<li>A module in <code>experiments/report</code> turns the rows into what the page shows, with the arithmetic in <code>experiments/report/statistics.py</code>. The template of the same name in
<code>experiments/report/templates</code> shows it. <code>experiments/report/page.py</code> lists the sections in their order.</li>
<li><code>experiments/report/build out/results out/report</code> draws the page again from the existing tables, in seconds. <code>experiments/report/check</code> checks the page.</li>
<li><code>experiments/report/test</code> has values that were worked out by hand, and tables that must be refused.</li></ol></section>
"""

ROUNDING = """
<section><p>The lemmas hold over the reals, but the refits run in <code>double</code>. Every ball carries a slack that makes up for all rounding, both of the
refit and of the skinning that it is compared with. The slack is derived before any number is known, from elementary bounds and a few lengths of the pose.
The comment of this file has the derivation. Its numbers are constants that the refits use.</p>
[[include algorithms/runtime/skinning/palette_rounding.hpp]]</section>
<section><h2>What checks it</h2><p>Gappa proves each elementary bound, by component and at unit length (<code>proptests/gappa</code>). The suite
<code>palette_rounding</code> puts the code's own constants in place of <code>BOUND</code>. It also requires that Gappa cannot prove three quarters of these constants. Further tests
use running error bounds of the same templates. They check that the bounds hold at any length and compose as the comment says. The allowance must be enough, and some case must use at least half
of it, so that a lost factor of two is noticed. Finally, vertices are skinned in exact rationals, and no ball may miss one even by the last bit.</p>
[[include proptests/gappa/rotate_scaled.g]]
<p>Exercise: halve the slack in <code>algorithms/runtime/refit/rounding.hpp</code>; does any exact comparison notice? Which property does? This command gives the answer:
<code>proptests/mutants/run --only "rounding: the slack is halved"</code>.</p></section>
"""

ERRORS = """
<section><p>This table lists everything that the library and the readers of the tests refuse, with the place and the suite that provokes it. The tests fail if the sources throw
an error that is not listed here, or if a suite does not provoke an error that is listed for it.</p>
[[table proptests/errors.md]]</section>
"""

ROLES = [("programmer", "For the programmer: the refit in an engine", PROGRAMMER),
         ("researcher", "For the researcher: add a variant, a volume, a lemma", RESEARCHER),
         ("rounding", "Rounding: from the reals to double", ROUNDING), ("errors", "Errors", ERRORS)]
