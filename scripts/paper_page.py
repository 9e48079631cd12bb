"""The page of results/paper: what the paper says, what the runs gave, and whether that agrees."""
from paper_figures import DRAWINGS
from paper_runs import PRESSES_MM, SPEEDS_M_S, THICKNESSES_MM

CONFIRMED, REFUTED, UNTESTED = "confirmed", "**not confirmed**", "cannot be tested"
HELD_MM = 0.5  # what counts as a tool that stays outside; the blade is 2 mm thick
HEAD = """# The paper, run again

    scripts/reproduce            # builds, runs all of this and writes it anew, in four minutes on two shared cores
    scripts/reproduce --check    # runs, and compares with numbers.csv and this page

The statements and figures of the paper that this project implements, "Implementation of a Soft-Rigid Collision Algorithm in an
Open-Source Engine for Surgery Realistic Simulation", and what comes out when they are run. Every measured number on this page is taken from
the runs that made it ([all of them](numbers.csv)). The text gives no numbers but the 128 triangles; its figures are pictures and one curve.
No parameter of the tissue, the tool or the force law is stated either: those here are the ones of [configs](../../configs), so that
sizes of forces mean nothing beside the paper's.

*Paper's method* is the paper's two steps and nothing else (`pipeline: fukuhara, response: none, vertex_contacts: false`); *fissure* is
the same with what this project added (`pipeline: fukuhara`); *swept* is contact of the whole surface without nodes, this project's own
(`pipeline: swept`). Held: at most {held} mm deep, no triangle inside out, nothing passed through. Scenes, unless said otherwise: [spatula_press](../../configs/spatula_press.yaml), a blade 2 mm thick pressed 25 mm into a
sphere of 128 triangles at 0.1 m/s.

| the paper says | the runs gave | picture | |
|---|---|---|---|
"""


def held(n, key):
    return n[f"{key}/depth"] <= HELD_MM and n[f"{key}/inverted"] == 0 and n[f"{key}/passed"] == 0


def depth(n, key):
    beside = [f"{n[f'{key}/{what}']:.0f} {words}" for what, words in (("inverted", "inside out"), ("passed", "passed through"))
              if n[f"{key}/{what}"]]
    return f"{n[f'{key}/depth']:.2f} mm" + (f" ({', '.join(beside)})" if beside else "")


def verdict(good, why_not=""):
    return CONFIRMED if good else f"{REFUTED}{': ' + why_not if why_not else ''}"


def small_and_slow(n):
    slow, fast = (f"spatula_{speed}_{PRESSES_MM[0]}/default_tuned" for speed in (SPEEDS_M_S[0], SPEEDS_M_S[-1]))
    deep = f"spatula_{SPEEDS_M_S[0]}_{PRESSES_MM[-1]}/default_tuned"
    stock = f"spatula_{SPEEDS_M_S[0]}_{PRESSES_MM[0]}/default"
    good = held(n, slow) and not held(n, fast) and not held(n, deep) and held(n, "plate_0.1/default_tuned") and not held(
        n, "plate_10/default_tuned")
    return ("Bullet's default collides consistently only for small displacements and slow motion",
            f"tuned: pressed 1 mm, {depth(n, slow)} at 0.02 m/s and {depth(n, fast)} at 2 m/s; pressed 25 mm at 0.02 m/s, "
            f"{depth(n, deep)}. A plate that covers many vertices, pressed 25 mm: {depth(n, 'plate_0.1/default_tuned')} at 0.1 m/s, "
            f"{depth(n, 'plate_10/default_tuned')} at 10 m/s. With Bullet's own settings not even that: {depth(n, stock)} of 1 mm",
            "", verdict(good) + (" for tuned settings" if good else ""))


def fast(n):
    good = all(n[f"fast/{run}/depth"] > 20 for run in ("default", "default_tuned"))
    return ("fast, the spatula penetrates completely into the soft body (Fig. 3 left)",
            f"2 m/s: {depth(n, 'fast/default')}, tuned {depth(n, 'fast/default_tuned')}; paper's method {depth(n, 'fast/paper')}, "
            f"fissure {depth(n, 'fast/fukuhara')}, swept {depth(n, 'fast/swept')}", "fig3_left.png", verdict(good))


def unstable(n):
    times = n["press/raycast/roughness"] / n["press/paper/roughness"]
    return ("ray casting without the association of nodes is unstable (Fig. 3 right)",
            f"{n['press/raycast/inverted']:.0f} of {n['press/triangles']:.0f} triangles inside out, a force {times:.0f} times as rough "
            "as with it", "fig3_right.png", verdict(n["press/raycast/inverted"] > 10 and times > 10))


def thickness(n):
    inverted = [n[f"thick_{mm}/raycast/inverted"] for mm in THICKNESSES_MM]
    cases = ", ".join(f"{mm} mm: {count:.0f}" for mm, count in zip(THICKNESSES_MM, inverted))
    return ("... if the rigid body is not large enough along the collision direction",
            f"triangles inside out by thickness of the blade: {cases}", "",
            verdict(inverted[-1] < 0.5 * inverted[0],
                    "a thicker blade is no better in this scene; why was not looked into"))


def overcome(n):
    times = n["press/raycast/roughness"] / n["press/paper/roughness"]
    return ("the second step, which leaves out infeasible collisions, overcomes this",
            f"paper's method {depth(n, 'press/paper')}, force {times:.0f} times smoother; fissure {depth(n, 'press/fukuhara')}, "
            f"swept {depth(n, 'press/swept')}",
            "fig3_right.png", verdict(held(n, "press/paper") and times > 10))


def edges(n):
    ratio = n["convex/thickest_pair"] / n["convex/thinnest_pair"]
    return ("at the side edge triangles may be two orders of magnitude closer than the thickness (Fig. 2)",
            f"pairs {n['convex/thinnest_pair']:.3f} to {n['convex/thickest_pair']:.2f} mm apart, a factor of {ratio:.0f}", "",
            f"{UNTESTED}: the paper's mesh is not published, and ours is bevelled so on purpose")


def mutual(n):
    share = n["convex/unmutual_nodes"] / n["convex/paired_nodes"]
    return ("on convex tools nodes are not always mutually associated",
            f"{n['convex/unmutual_nodes']:.0f} of {n['convex/paired_nodes']:.0f} paired nodes ({100 * share:.0f} %) are not", "",
            verdict(n["convex/unmutual_nodes"] > 0))


def limit(n):
    good = n["coarse/paper/inverted"] < 0.5 * n["unlimited/paper/inverted"]
    return ("limited rays highly reduce infeasible collisions",
            f"pairs along the tool allowed: {depth(n, 'unlimited/paper')}; left out: {depth(n, 'coarse/paper')}. The paper does not say "
            "how long its rays are; here a pair farther apart than `pairing_limit` thicknesses is none", "", verdict(good))


def convex(n):
    return ("the algorithm works on convex tools of triangles (Fig. 4)",
            f"paper's method {depth(n, 'coarse/paper')}, tissue of 512 triangles {depth(n, 'convex/paper')}; "
            f"fissure {depth(n, 'coarse/fukuhara')}, 512 triangles {depth(n, 'convex/fukuhara')}; "
            f"swept {depth(n, 'coarse/swept')}, 512 triangles {depth(n, 'convex/swept')}", "fig4.png",
            verdict(held(n, "coarse/paper"),
                    "the paper's two steps let the thin edge into the tissue; with contacts of tissue and response `momentum` it is "
                    + ("held on 512 triangles" if held(n, "convex/fukuhara") else "not held either")
                    + (", not on 128" if not held(n, "coarse/fukuhara") else " and on 128")
                    + ("; swept holds it on both" if held(n, "convex/swept") and held(n, "coarse/swept") else "")))


def clamp(n):
    good = all(held(n, f"{name}/{run}") for name, run in (("sphere_paper", "paper"), ("sphere", "fukuhara"),
                                                        ("vessel_paper", "paper"), ("vessel", "fukuhara")))
    return ("... and on a clamp that grasps a sphere and an elongated shape (Fig. 4)",
            f"sphere: paper's method {depth(n, 'sphere_paper/paper')}, fissure {depth(n, 'sphere/fukuhara')}, swept "
            f"{depth(n, 'sphere/swept')}; vessel: {depth(n, 'vessel_paper/paper')}, {depth(n, 'vessel/fukuhara')}, "
            f"{depth(n, 'vessel/swept')}, where friction, beyond the paper, lets the clamp lift it "
            f"({n['vessel/fukuhara/final_reaction']:.3f} N, its weight is 0.196 N)", "fig4.png", verdict(good))


def grasp(n):
    def held_by(key):
        return (f"{n[f'{key}/left_held']:.2f} and {n[f'{key}/right_held']:.2f} N by the jaws, "
                f"{n[f'{key}/resultant_held']:.2f} N left over")
    return ("resultant force on the grasped sphere (Fig. 5)",
            f"held: paper's method, without friction, {held_by('sphere_paper/paper')}; fissure, with friction, "
            f"{held_by('sphere/fukuhara')}", "fig5.png",
            f"{UNTESTED}: the text gives no number of the curve, and neither stiffness nor path of the clamp")


def law(n):
    worst = max(n[f"law/{run}/error"] for run in ("raycast", "paper", "fukuhara"))
    return ("F = k x^n + lambda x^n x', x from the triangle's centroid at time zero, over triangles with a colliding node",
            f"elastic term of all triangles, from the stored positions and contact states, against the recorded one: {worst:.0e} N "
            "apart at most; the rate's part is measured in [force_impact](../force_impact/README.md)", "", verdict(worst < 1e-9))


def scene(n):
    return ("the sphere has 128 triangles", f"{n['press/triangles']:.0f}", "", verdict(n["press/triangles"] == 128))


STATEMENTS = [scene, small_and_slow, fast, unstable, thickness, overcome, mutual, edges, limit, convex, clamp, grasp, law]
BEYOND = """
Cannot be tested:

* "Realistic both in terms of visual rendering and in terms of force feedback", a force model "more realistic": nobody has judged it,
  here or in the paper. The frames above are what there is to look at.
* The Novint Falcon: no device. Logs in its format are replayed (the vessel's clamp above is moved by two axes of such a log and opened
  by the third, as the paper has it), but the logs are made, not recorded.
* Whether it ran in real time: the paper does not say, and times here are not of its machine.
* The paper's pictures themselves: camera, sizes and path of the tool are not stated.
"""


def statement_rows(n):
    for statement in STATEMENTS:
        says, gave, picture, said = statement(n)
        shown = f'<a href="{picture}"><img src="{picture}" alt="{DRAWINGS[picture].__doc__}" width="260"></a>' if picture else ""
        yield f"| {says} | {gave} | {shown} | {said} |\n"


def page_text(n):
    return HEAD.format(held=HELD_MM) + "".join(statement_rows(n)) + BEYOND


def write_page(folder, results, numbers):
    for name, draw in DRAWINGS.items():
        draw(results, folder / name)
    (folder / "README.md").write_text(page_text(numbers))
