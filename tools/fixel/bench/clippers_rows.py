# SPDX-License-Identifier: MIT
"""From what was drawn, judged and counted to the rows of clippers.json, and what is wrong with them."""

import json

from fixel.bench import clippers_run

CLAIM_BEYOND = 1e-4     # of outlines may be beyond the claim: docs/extras/clippers.md says why


def row(plan, core, combination, scene, host, drawn, text_bytes):
    """A row: one combination, scene and core."""
    verdict, found = host["verdict"], host["found"]
    return {"clipper": combination.clipper, "hidden": combination.hidden, "scene": scene["name"], "board": core,
            "frames": len(drawn["instructions"]), "instructions": clippers_run.summary(drawn["instructions"]),
            "text_bytes": text_bytes, "ram_bytes": drawn["memory"], "stack_bytes": drawn["stack"],
            "max_error_units": found["max_error_units"], "max_error_units_at_all": found["max_error_units_at_all"],
            "pixels": verdict["pixels"], "pixels_differing": verdict["pixels_differing"],
            "pixels_tied": verdict["pixels_tied"], "pixels_unexplained": verdict["pixels_unexplained"],
            "max_edge_distance_px": verdict["max_edge_distance_px"],
            "explained_px": plan.explained(combination.clipper, scene["image"]),
            "equal_to_host": drawn["sums"] == host["sums"],
            "crcs": [f"{value:08x}" for value in host["sums"]],
            **{key: found[key] for key in ("faces", "crossing", "missed", "refused", "beyond", "vertices",
                                           "screen_px", "view_units", "intersections", "distances")},
            "split_bands": host["split_bands"]}


def operation_rows(counted, hosts, hidden):
    """[{clipper, scene, board, crossing, polygons, instructions, multiplications, divisions, intersections,
    distances}]: all of a scene's frames together. crossing: polygons that the planes of the lens cut, whoever cuts
    them;
    intersections and distances from planes are the whole scene's, the rest is that of the polygons cut."""
    rows = []
    for (core, clipper, scene), taken in counted.items():
        found = hosts[clipper, hidden, scene]["found"]
        rows.append({"clipper": clipper, "scene": scene, "board": core, "crossing": found["crossing"], **taken,
                     "intersections": found["intersections"], "distances": found["distances"]})
    return rows


def complaints(plan, result):
    """Everything that is not as it should be, in sentences."""
    found = []
    for each in result["rows"]:
        name = f"{each['clipper']} x {each['hidden']}, {each['scene']}, {each['board']}"
        if each["pixels_unexplained"]:
            found.append(f"{name}: {each['pixels_unexplained']:,} pixels differ from double without explanation")
        if not each["equal_to_host"]:
            found.append(f"{name}: the frames of the emulated core are not those of the host")
        claim = plan.clippers[each["clipper"]].get("claim")
        if claim and each["max_error_units"] > claim and each["beyond"] > CLAIM_BEYOND * each["faces"]:
            found.append(f"{name}: {each['beyond']:,} of {each['faces']:,} outlines err by more than {claim}/65536 "
                         f"pixel, by {each['max_error_units']:.3g} at most")
        if each["missed"]:
            found.append(f"{name}: {each['missed']:,} faces are drawn or left out unlike exact clipping")
        if each["refused"]:
            found.append(f"{name}: {each['refused']:,} faces were refused")
    return found


def as_lines(result):
    """clippers.json with a line for each row, without the frames' CRCs."""
    def lines(rows):
        kept = ({key: value for key, value in row.items() if key != "crcs"} for row in rows)
        return "[\n" + ",\n".join(json.dumps(row, separators=(",", ":")) for row in kept) + "]"
    return "{" + ",\n".join(f"{json.dumps(key)}: {lines(value) if key == 'rows' else json.dumps(value)}"
                            for key, value in result.items()) + "}\n"
