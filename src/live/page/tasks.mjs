/* SPDX-License-Identifier: MIT */
/* What to find in a scene, with a tolerance of 2 %. The numbers are those of the library. Scene 2 has its own three.
 * found: of the run, the values of the controls and the readings; tasks are named in words, in this order. */
const near = (value, wanted) => Math.abs(value - wanted) <= .02 * Math.abs(wanted);
const rolls = (r, i = 0) => Math.abs(r.contacts[i].vs) <= .02 * Math.abs(r.contacts[i].vr);
const ended = ({world}, scene) => world.time() > .99 * scene.seconds;

export const TASKS = {
    rim: [(run, s, r) => near(r.contacts[0].vr, .8) && rolls(r), (run, s, r) => near(r.contacts[0].vs, -.5) && s.v > 0],
    wheels: [(run, s, r) => near(Math.abs(r.contacts[2].vr), 2 * Math.abs(r.contacts[0].vr)) && s.v !== 0],
    coin: [run => near(run.world.disk(1).angle / (2 * Math.PI), 5) && ended(run, run.scene)],
    throw: [(run, s) => s.v > .1 && run.world.disk(0).vx<-.05, (run, s) => s.v>.1 && ended(run, run.scene) &&
                        Math.abs(run.world.disk(0).vx) <= .02 * s.v],
    carpet: [(run, s, r) => s.v > .1 && run.world.disk(0).x < 0 && rolls(r)],
    who: [(run, s, r) => Math.abs(s.ratio) >= .1 && Math.min(Math.abs(s.w1), Math.abs(s.w2)) >= .2 &&
                         Math.abs(r.contacts[0].vs) <= .02 * Math.abs(r.contacts[0].vr)],
    thief: [(run, s, r) => near(r.last, 20), (run, s, r) => r.last < -5],
    slope: [
        (run, s) => s.slope >= 15 && ended(run, run.scene) && Math.abs(run.world.disk(0).vx) < .01,
        (run, s, r) => s.slope <= 15 && ended(run, run.scene) && Math.abs(r.contacts[0].vs) > .05
    ],
    gears: [(run, s, r) =>
                run.world.time() > 1 && s.mu > 0 && !r.sliding && near(Math.abs(run.world.disk(s.n - 1).spin), 2)],
    inside: [
        (run, s, r) => Math.abs(r.now.u_roll) >= 3 * r.now.a && near(Math.abs(r.now.creepage), 1e-3),
        (run, s, r) => r.now.rolls !== 0 && near(r.now.stick / (2 * r.now.a), .25)
    ],
    sample: [(run, s) => run.memory.last.strain > .02 && near(Math.max(...run.memory.curve.map(k => k[1])), .4)],
};

/* Which are found now, added to those before. hits: a set of numbers. */
export function findTasks(run, state, r, hits) {
    (TASKS[run.scene.id] ?? []).forEach((found, i) => run.world.steps && found(run, state, r) && hits.add(i));
}
