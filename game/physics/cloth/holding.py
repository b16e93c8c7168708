"""What of a cloth still holds: meshes that are burnt through or torn out, threads, the way to the hooks."""

from __future__ import annotations

import math

from game.compiler.decorator import inner_kernel, lean_kernel
from game.physics.cloth import layout

MOST_ROUNDS = 12  # of sweeps for the ways to the hooks
SHORTER = 0.96  # of a way over threads and diagonals, which is up to 8 % longer than a straight one
LIGHTEST = 0.12  # of its first mass: no node is lighter, however much has burnt


@inner_kernel
def solid_share(patches, j, i, dry):
    """How much of a mesh's first mass (``dry`` kg/m²) is left, water apart."""
    total = 0.0
    for b in range(layout.PER * j, layout.PER * j + layout.PER):
        for a in range(layout.PER * i, layout.PER * i + layout.PER):
            total += patches[layout.FUEL, b, a] + patches[layout.CHAR, b, a]
    return total / (layout.PER * layout.PER * dry)


@lean_kernel
def burn_through(patches, whole, dry, least):
    """Meshes with less than a share ``least`` of their mass hold no more; how many. Their heat goes with
    them: see `take_ash`.
    """
    gone = 0
    for j in range(whole.shape[0]):
        for i in range(whole.shape[1]):
            if whole[j, i] > 0.0 and solid_share(patches, j, i, dry) < least:
                whole[j, i] = -1.0
                gone += 1
    return gone


@lean_kernel
def tear_out(nodes, ties, patches, limits):
    """Threads stretched beyond what they bear take the weaker mesh beside them with them; how many meshes.

    limits: strain that a whole thread bears, m between threads, kg/m² of the cloth. A burnt one bears less
    in proportion to what is left.
    """
    most, spacing, dry = limits
    ny, nx = ties.whole.shape
    torn = 0
    for j in range(ny + 1):
        for i in range(nx + 1):
            for way in range(2):
                jb, ib = (j, i + 1) if way == 0 else (j + 1, i)
                if jb > ny or ib > nx:
                    continue
                if (ties.across[j, i] if way == 0 else ties.along[j, i]) <= 0.0:
                    continue
                dx, dy = (
                    nodes[layout.X, jb, ib] - nodes[layout.X, j, i],
                    nodes[layout.Y, jb, ib] - nodes[layout.Y, j, i],
                )
                dz = nodes[layout.Z, jb, ib] - nodes[layout.Z, j, i]
                strain = math.sqrt(dx * dx + dy * dy + dz * dz) / spacing - 1.0
                if strain <= 0.1 * most:
                    continue
                # the two meshes beside the thread
                ja, ia = (j - 1, i) if way == 0 else (j, i - 1)
                one = (
                    solid_share(patches, ja, ia, dry)
                    if ja >= 0 and ia >= 0 and ties.whole[ja, ia] > 0.0
                    else -1.0
                )
                two = (
                    solid_share(patches, j, i, dry) if j < ny and i < nx and ties.whole[j, i] > 0.0 else -1.0
                )
                strong = max(one, 0.0) + max(two, 0.0)
                parts = (1.0 if one >= 0.0 else 0.0) + (1.0 if two >= 0.0 else 0.0)
                if parts == 0.0 or strain <= most * max(strong / parts, 0.1):
                    continue
                if two >= 0.0 and (one < 0.0 or two <= one):
                    ties.whole[j, i] = -1.0
                else:
                    ties.whole[ja, ia] = -1.0
                torn += 1
    return torn


@lean_kernel
def take_ash(patches, whole, numbers, ash):
    """Meshes that were just lost (-1) become 0; what they had goes with them.

    numbers: J/(m² K) of the dry cloth, J/(kg K) of water, K around, m² of a patch. ash (4,), added to: J
    above the surroundings, kg of fuel, of char, of water. The patches are empty then, and cold.
    """
    capacity, water_heat, ambient, area = numbers
    for j in range(whole.shape[0]):
        for i in range(whole.shape[1]):
            if whole[j, i] >= 0.0:
                continue
            whole[j, i] = 0.0
            for b in range(layout.PER * j, layout.PER * j + layout.PER):
                for a in range(layout.PER * i, layout.PER * i + layout.PER):
                    per = capacity + water_heat * patches[layout.WATER, b, a]
                    ash[0] += area * per * (patches[layout.HOT, b, a] - ambient)
                    ash[1] += area * patches[layout.FUEL, b, a]
                    ash[2] += area * patches[layout.CHAR, b, a]
                    ash[3] += area * patches[layout.WATER, b, a]
                    patches[layout.HOT, b, a] = ambient
                    patches[layout.FUEL, b, a], patches[layout.CHAR, b, a], patches[layout.WATER, b, a] = (
                        0.0,
                        0.0,
                        0.0,
                    )


@lean_kernel
def tie(nodes, ties, hooked):
    """Threads and nodes that are there, from the meshes that are whole. hooked (2,): which upper corners
    hang on a hook; an empty one lets go.
    """
    ny, nx = ties.whole.shape
    for j in range(ny + 1):
        for i in range(nx + 1):
            here = 0.0
            for b in range(max(j - 1, 0), min(j + 1, ny)):
                for a in range(max(i - 1, 0), min(i + 1, nx)):
                    here = max(here, ties.whole[b, a])
            nodes[layout.THERE, j, i] = here
            if i < nx:
                above = ties.whole[j - 1, i] if j > 0 else 0.0
                ties.across[j, i] = max(above, ties.whole[j, i] if j < ny else 0.0)
            if j < ny:
                beside = ties.whole[j, i - 1] if i > 0 else 0.0
                ties.along[j, i] = max(beside, ties.whole[j, i] if i < nx else 0.0)
    for k in range(2):
        if nodes[layout.THERE, 0, nx * k] <= 0.0:
            hooked[k] = 0.0


@lean_kernel
def weigh(nodes, patches, whole, mesh, dry):
    """Inverse masses of nodes from what their meshes weigh. mesh: m² of one; dry: kg/m². Those that are not
    there get 0.
    """
    ny, nx = whole.shape
    least = LIGHTEST * 0.25 * mesh * dry
    for j in range(ny + 1):
        for i in range(nx + 1):
            mass = 0.0
            for b in range(max(j - 1, 0), min(j + 1, ny)):
                for a in range(max(i - 1, 0), min(i + 1, nx)):
                    if whole[b, a] > 0.0:
                        for d in range(layout.PER * b, layout.PER * b + layout.PER):
                            for c in range(layout.PER * a, layout.PER * a + layout.PER):
                                mass += (
                                    patches[layout.FUEL, d, c]
                                    + patches[layout.CHAR, d, c]
                                    + patches[layout.WATER, d, c]
                                )
            mass *= 0.25 * mesh / (layout.PER * layout.PER)
            nodes[layout.INVERSE, j, i] = 1.0 / max(mass, least) if nodes[layout.THERE, j, i] > 0.0 else 0.0


@inner_kernel
def _nearer(reach, there, j, i, b, a, step):
    """The way by way of a neighbour, if that is there."""
    if b < 0 or a < 0 or b >= reach.shape[0] or a >= reach.shape[1] or there[b, a] <= 0.0:
        return reach[j, i]
    return min(reach[j, i], reach[b, a] + step)


@lean_kernel
def find_reach(nodes, ties, hooked, spacing):
    """Ways (m) along the cloth to either hook, over threads and diagonals of whole meshes: sweeps in four
    orders until nothing changes; at least as far as it is straight.
    """
    rows, columns = nodes.shape[1], nodes.shape[2]
    there, slant = nodes[layout.THERE], spacing * math.sqrt(2.0)
    for k in range(2):
        reach = ties.reach[k]
        for j in range(rows):
            for i in range(columns):
                reach[j, i] = math.inf
        if hooked[k] <= 0.0:
            continue
        reach[0, (columns - 1) * k] = 0.0
        for turn in range(4 * MOST_ROUNDS):
            changed = 0
            down, right = turn % 2 == 0, (turn // 2) % 2 == 0
            for row in range(rows):
                j = row if down else rows - 1 - row
                for column in range(columns):
                    i = column if right else columns - 1 - column
                    if there[j, i] <= 0.0:
                        continue
                    old = reach[j, i]
                    for side in range(2):
                        b, a = j + 2 * side - 1, i + 2 * side - 1
                        thread = ties.along[j - 1 + side, i] if 0 <= b < rows else 0.0
                        if thread > 0.0:
                            reach[j, i] = _nearer(reach, there, j, i, b, i, spacing)
                        thread = ties.across[j, i - 1 + side] if 0 <= a < columns else 0.0
                        if thread > 0.0:
                            reach[j, i] = _nearer(reach, there, j, i, j, a, spacing)
                    for corner in range(4):
                        b, a = j + 2 * (corner // 2) - 1, i + 2 * (corner % 2) - 1
                        mesh_j, mesh_i = j - 1 + corner // 2, i - 1 + corner % 2
                        inside = 0 <= mesh_j < rows - 1 and 0 <= mesh_i < columns - 1
                        if inside and ties.whole[mesh_j, mesh_i] > 0.0:
                            reach[j, i] = _nearer(reach, there, j, i, b, a, slant)
                    if reach[j, i] < old - 1e-9:
                        changed += 1
            if changed == 0 and turn >= 3:
                break
        for j in range(rows):
            for i in range(columns):
                aside = i - (columns - 1) * k
                straight = spacing * math.sqrt(float(j * j + aside * aside))
                reach[j, i] = max(straight, SHORTER * reach[j, i])


@lean_kernel
def name_pieces(whole, names, stack):
    """Number the pieces that meshes form, which hold together at a corner too: names (ny, nx), -1 where there
    is none; how many. stack (ny nx, 2) to work in.
    """
    ny, nx = whole.shape
    for j in range(ny):
        for i in range(nx):
            names[j, i] = -1
    count = 0
    for j in range(ny):
        for i in range(nx):
            if whole[j, i] <= 0.0 or names[j, i] >= 0:
                continue
            names[j, i] = count
            stack[0, 0], stack[0, 1], height = j, i, 1
            while height > 0:
                height -= 1
                row, column = stack[height, 0], stack[height, 1]
                for b in range(max(row - 1, 0), min(row + 2, ny)):
                    for a in range(max(column - 1, 0), min(column + 2, nx)):
                        if whole[b, a] > 0.0 and names[b, a] < 0:
                            names[b, a] = count
                            stack[height, 0], stack[height, 1] = b, a
                            height += 1
            count += 1
    return count
