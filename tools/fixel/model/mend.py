# SPDX-License-Identifier: MIT
"""Winding of a model's faces: neighbours that disagree about the front are turned until they agree."""


def _edges(faces):
    """{(low, high): [(face, whether it runs from low to high)]}."""
    found = {}
    for number, face in enumerate(faces):
        for a, b in zip(face.corners, face.corners[1:] + face.corners[:1]):
            found.setdefault((min(a, b), max(a, b)), []).append((number, a < b))
    return found


def _agree(faces):
    """Whether no two faces run along an edge in the same direction."""
    ways = [way for face in faces for way in zip(face.corners, face.corners[1:] + face.corners[:1])]
    return len(set(ways)) == len(ways)


def faces_to_turn(faces):
    """Numbers of the faces to be turned round so that all neighbours agree; a set. Neighbours are two faces that
    share an edge no third face has. Of each connected part the smaller half is turned. A part that cannot agree, such
    as a Moebius band, is left as it is."""
    if _agree(faces):
        return set()
    pairs = {}
    for both in _edges(faces).values():
        if len(both) == 2 and both[0][0] != both[1][0]:
            (one, up), (other, down) = both
            pairs.setdefault(one, []).append((other, up == down))
            pairs.setdefault(other, []).append((one, up == down))
    turned, result = {}, set()
    for start in range(len(faces)):
        if start in turned:
            continue
        turned[start], part, sound = False, [start], True
        for number in part:
            for neighbour, differs in pairs.get(number, []):
                wanted = turned[number] != differs
                if neighbour not in turned:
                    turned[neighbour] = wanted
                    part.append(neighbour)
                sound = sound and turned[neighbour] == wanted
        chosen = [number for number in part if turned[number]]
        if 2 * len(chosen) > len(part):
            chosen = [number for number in part if not turned[number]]
        if sound:
            result.update(chosen)
    return result
