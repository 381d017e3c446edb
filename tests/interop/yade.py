# SPDX-License-Identifier: MIT
# The card in YADE, CohFrictMat with the moment law: yade -n -x yade.py CARD.csv ANSWERS.csv. Places are frozen (no integrator), ten
# steps in the time of the card; without an integrator ForceResetter lets forces add up, so the last step's difference counts. YADE
# makes the stiffnesses of a contact from those of the materials; forces are scaled to the springs of the card. Pairs alone. With
# RATCHETING=yes in the environment avoidGranularRatcheting is off.
import csv
import math
import os
import sys

card, answers = sys.argv[-2:]
N, E = 10, 1e6
avoid = os.environ.get("RATCHETING") != "yes"
code = "YADE " + yade.config.version + ("" if avoid else " avoidGranularRatcheting=False")


def material(friction_angle, alpha, eta):
    return CohFrictMat(young=E, poisson=.5, density=2700, frictionAngle=friction_angle, alphaKr=alpha, alphaKtw=0,
                       etaRoll=eta, momentRotationLaw=True, isCohesive=False)


def play(m, mat, dt):
    O.reset()
    g = lambda s: float(m[s])
    number = O.materials.append(mat)
    ids = [O.bodies.append(sphere((g("x%dx" % b), g("x%dy" % b), 0), g("R%d" % b), material=number)) for b in (1, 2)]
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D(avoidGranularRatcheting=avoid)],
                        [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionOnNewContacts=False)],
                        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment(always_use_moment_law=True, useIncrementalForm=True)])
    ]
    O.dt = dt
    for b in (1, 2):
        state = O.bodies[ids[b - 1]].state
        state.vel = (g("v%dx" % b), g("v%dy" % b), 0)
        state.angVel = (0, 0, g("w%d" % b))

    def forces():
        return [O.forces.t(ids[0])[2], O.forces.t(ids[1])[2], Vector3(O.forces.f(ids[1]))]

    for _ in range(N - 1):
        O.step()
    before = forces()
    O.step()
    return [b - a for a, b in zip(before, forces())], [i for i in O.interactions if i.isReal][0].phys


def answer(m):
    g = lambda s: float(m[s])
    dx, dy = g("x2x") - g("x1x"), g("x2y") - g("x1y")
    L = math.hypot(dx, dy)
    n = (dx / L, dy / L)
    t = (n[1], -n[0])
    overlap, dt = g("R1") + g("R2") - L, g("time") / N
    if m["experiment"] == "roll":
        (T1, T2, f), phys = play(m, material(0., 1., -1.), dt)
        k = g("k_roll") / phys.ks
        return 0, T1 * k, T2 * k, 0
    if m["experiment"] == "cap":
        (T1, T2, f), phys = play(m, material(0., 1e9, 1e-9), dt)
        k = g("mu_r") * g("k_n") * overlap / (1e-9 * math.hypot(f[0], f[1]))
        return g("k_n") * overlap, T1 * k, T2 * k, 0
    (T1, T2, f), phys = play(m, material(1.5607966601082315, 0., -1.), dt)  # tan is 100
    k = g("k_t") / phys.ks
    return 0, T1 * k, T2 * k, -(f[0] * t[0] + f[1] * t[1]) * k


with open(card) as rows, open(answers, "w", newline="") as out:
    reader = csv.DictReader(rows)
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(reader.fieldnames + ["code", "F_n", "F_t", "M1", "M2"])
    for m in reader:
        if m["R1"] != "inf":
            F_n, M1, M2, F_t = answer(m)
            writer.writerow(list(m.values()) + [code, F_n or "", F_t, M1, M2])
