// SPDX-License-Identifier: MIT
// What the scenes tell, against closed forms. usage: node scenes.mjs PAGE LIVE.wasm
import {readFileSync} from 'node:fs';
const [page, wasm] = process.argv.slice(2);
globalThis.WORDS = JSON.parse(readFileSync(`${page}/words.en.json`, 'utf8'));
const {SCENES, defaults} = await import(`${page}/show.mjs`);
const {loadEngine} = await import(`${page}/engine.mjs`);
const engine = await loadEngine(readFileSync(wasm));

// A scene with some values, after a share of its time.
function at(id, values, share = 1) {
    const scene = SCENES.find(s => s.id === id), state = {...defaults(scene), ...values},
          world = scene.open ? scene.open(engine, state) : engine.open(0, scene.text(state));
    const run = {scene, world, engine}, steps = Math.floor(share * scene.seconds / world.dt);
    run.memory = scene.begin(world, state, null), scene.after?.(run);
    for (let k = 0; k < 20; k++) world.step(Math.floor(steps / 20)), scene.after?.(run);
    return {run, state, read: scene.read(run, state), world};
}
let bad = 0;
function close(what, got, wanted, tolerance) {
    if (Math.abs(got - wanted) <= tolerance) return;
    console.log(`${what}: ${got}, expected ${wanted} within ${tolerance}`);
    bad++;
}
const number = text => Number(String(text).replace('−', '-').split(' ')[0]);

// V_s = R w + V, V_r = -R w [Wang2015 eqs. 14, 15]; R is short of the radius by the overlap, 1 um: 4e-6 m/s at 4 rad/s.
for (const [v, w] of [[1, -4], [.5, 0], [0, 3], [-.4, 1]]) {
    const [c] = at('rim', {v, w}, .1).read.contacts;
    close(`rim ${v} ${w}: slides`, c.vs, .25 * w + v, 1e-5), close(`rim ${v} ${w}: rolls`, c.vr, -.25 * w, 1e-5);
}
// Rigid rotation, rolling and sliding are found.
for (const [values, wanted] of [[{w1: 1, w2: 1, turn: 1}, 'rigid'],
                                [{w1: 1, w2: -1, turn: 0, R1: .2, R2: .2}, 'rolling'],
                                [{w1: 1, w2: 1, turn: 0, R1: .2, R2: .2}, 'sliding']])
    if (at('pair', values, .05).run.memory.hits.join() !== wanted) console.log(`pair: not ${wanted}`), bad++;
// 1 + R1/R2 turns in a round; the run ends 2e-4 before the round does.
for (const ratio of [1, 3, 10])
    close(`coin ${ratio}`, number(at('coin', {ratio}).read.lines[0][1]), 1 + ratio, .01 * (1 + ratio));
// A disk ends with 2/3 of its speed, a sphere with 5/7; back-spin w brings it back with (2 v - R w)/3. The spring
// of the contact swings on, by mu g/w_t with w_t = sqrt(3 k_t/m), 0.003 m/s at mu = 0.3.
for (const [values, wanted] of [[{mu: .3, v: 1}, 2 / 3], [{mu: .1, v: 1}, 2 / 3],
                                [{mu: .3, v: 1, shape: 'sphere'}, 5 / 7], [{mu: .3, v: 1, w: 12}, (2 - 3) / 3]])
    close(`throw ${JSON.stringify(values)}`, at('throw', values).world.disk(0).vx, wanted, .006);
// Friction along the floor keeps the angular momentum about its points, so ice before the carpet changes nothing. On
// ice of mu = 0.02 the wheel comes to the carpet, 0.6 m on, with v1 = sqrt(v0^2 - 2 mu g 0.6 m), and has turned to 2
// (v0 - v1).
close('carpet', at('carpet', {}).world.disk(0).vx, 2 / 3, .006);
{
    const {memory} = at('carpet', {}).run, mu = .02, v1 = Math.sqrt(1 - 2 * mu * 9.81 * .6),
          edge = (1 - v1) / mu / 9.81;
    const last = memory.rim.filter(([t]) => t < edge).at(-1); // the springs take up to mu g/w_t, 0.001 m/s at mu = 0.02
    close('carpet: the rim on the ice', last[1], 2 * mu * 9.81 * last[0], .002);
}
// The closed forms that the scene itself shows, against the run: both laws, all regions of the map, from rest over
// 0.6 s. The springs take up to 0.01 m/s.
for (const law of ['wang', 'bagi-kuhn'])
    for (const [slope, mu, mu_r] of [[4, .3, .1], [15, .3, .1], [25, .3, .2], [45, .3, .2], [50, .1, .05],
                                     [20, .1, .35], [40, .1, .35], [30, .5, 0], [3, .05, .4]]) {
        const lines = at('slope', {slope, mu, mu_r, law}).read.lines;
        close(`slope ${slope} ${mu} ${mu_r} ${law}`, number(lines[0][1]), number(lines[1][1]), .03);
    }
// Moments alone by the mean flow make k_r R_eff (R2 - R1)/(2 L) du dtheta in a loop: 1e5 * 0.2/3 * 0.1/0.5998 * 0.009
// at ratio 2, backwards the opposite, at ratio 1 nothing. wang and conjugate forces make nothing, nor does a passive
// spring ever. Springs are linear: only rounding is left, of 1e5 N/m that press, over 0.06 m in 10 loops.
for (const [values, each] of [[{}, 1e5 * .2 / 3 * .1 / (2 * .2999) * .009],
                              [{du: -30}, -1e5 * .2 / 3 * .1 / (2 * .2999) * .009], [{ratio: 1}, 0],
                              [{thiefBy: 'wang'}, 0], [{thiefLaw: 'conjugate-spring'}, 0],
                              [{thiefLaw: 'conjugate-spring', thiefBy: 'wang'}, 0], [{thiefBy: 'alonso-mean'}, 0],
                              [{thiefLaw: 'passive-spring', thiefBy: 'wang'}, 0]]) {
    const {world, read} = at('thief', values);
    close(`thief ${JSON.stringify(values)}`, world.state().work, 10 * each, 1e-8);
    close('thief: its closed form', number(read.lines[3][1].replace('–', each)), each, 5e-3 * Math.abs(each));
}
for (const thiefBy of ['bagi-kuhn', 'alonso-min', 'alonso-mean']) {
    const made = at('thief', {thiefLaw: 'passive-spring', thiefBy}).world.state().work;
    if (made > 1e-8) console.log(`thief: a passive spring made ${made} J/m`), bad++;
}
// At the end of the push, the stick zone is a sqrt(1 - q) wide on each side, and the slide is that of [Johnson1985
// sec. 7.2] with Lambda = 4.5; rolling, the creepage is (mu a/R_star)(1 - sqrt(1 - q)) of the sign of q [Carter1926].
// An element of 100 is a fiftieth of a: the edges are good to one each, the slide to the square of it, the steady
// creepage to 2 %.
for (const [q, press, mu] of [[.6, 10, .3], [-.3, 25, .5], [.9, 2, .1]]) {
    const E_star = 70e9 / 2 / .91, P = 1e3 * press, a = Math.sqrt(4 * P * .005 / Math.PI / E_star), size = Math.abs(q);
    const push = at('inside', {q, press, mu}, .2).run.world.state();
    close(`inside ${q}: a`, push.a, a, 1e-9 * a), close(`inside ${q}: Q`, push.Q, q * mu * P, 1e-9 * mu * P);
    close(`inside ${q}: sticks`, push.stick, 2 * a * Math.sqrt(1 - size), .04 * a);
    const u = 2 * mu * P / Math.PI / E_star * (size * (4.5 + .5) + .5 * (1 - size) * Math.log(1 - size));
    // Lambda is that of the first force, and no other comes.
    close(`inside ${q}: slide`, push.u_slide, Math.sign(q) * u, 4e-4 * u);
    for (const far of [6, -6]) {
        const now = at('inside', {q, press, mu, far}).run.world.state(),
              creep = mu * a / .005 * (1 - Math.sqrt(1 - size));
        close(`inside ${q}, rolls ${far} a: creepage`, now.creepage, Math.sign(q) * creep, .02 * creep);
        close(`inside ${q}, rolls ${far} a: sticks`, now.stick, 2 * a * Math.sqrt(1 - size), .04 * a);
    }
}
// Rings of an even number turn as gears do, with the spin of the first; in odd ones something slides.
for (let n = 3; n <= 8; n++) {
    const {world, read} = at('gears', {n}), sliding = number(read.lines[0][1]);
    if ((sliding > 0) !== (n % 2 === 1)) console.log(`gears ${n}: ${read.lines[0][1]} slide`), bad++;
    if (n % 2 === 0)
        for (let k = 1; k < n; k++) close(`gears ${n}: spin of ${k}`, world.disk(k).spin, k % 2 ? -2 : 2, .05);
}
// Each task has an answer, and the scene as it opens is none. The thief makes 10 J/m, here twice of it, or the
// opposite; a disk stops dead where 2 v = R w.
const {TASKS, findTasks} = await import(`${page}/tasks.mjs`);
const most = .3 * Math.sqrt(4 * 1e4 * .005 / Math.PI / (70e9 / 2 / .91)) / .005; // creepage at q = 1: mu a/R_star
const answers = {
    rim: [{v: .8, w: -3.2}, {v: .5, w: -4}],
    wheels: [{v: .4, w: 3.2}],
    coin: [{ratio: 4}],
    throw: [{mu: .5, v: 1, w: 15}, {mu: .5, v: 1, w: 8}],
    carpet: [{mu: .5, v: .8}],
    who: [{ratio: .3, w1: 1, w2: -(10 ** -.3)}],                     // R1 w1 + R2 w2 = 0
    thief: [{du: 40, dtheta: .45}, {du: -30}],                       // 10 J/m times (40 * 0.45)/(30 * 0.3)
    slope: [{slope: 15, mu_r: .3}, {slope: 15, mu: .05, mu_r: .01}], // tan 15 deg = 0.27 > 3 mu - 2 mu_r = 0.13
    gears: [{n: 4}],
    inside: [{q: 1 - (1 - .001 / most) ** 2}, {q: 15 / 16}], // most (1 - sqrt(1 - q)) = 0.1 %; sqrt(1 - q) = 1/4
};
for (const [id, values] of Object.entries(answers)) {
    const found = state => {
        const hits = new Set();
        for (const share of [.3, 1]) {
            const got = at(id, state, share);
            findTasks(got.run, got.state, got.read, hits);
        }
        return hits;
    };
    if (values.length !== TASKS[id].length || values.length !== WORDS.scene[id].tasks.length)
        console.log(`${id}: a task has no answer here`), bad++;
    values.forEach((state, i) => {
        if (!found(state).has(i)) console.log(`${id}: task ${i} is not found by ${JSON.stringify(state)}`), bad++;
    });
    const first = [...found({})];
    if (first.length) console.log(`${id}: task ${first} is found at once`), bad++;
}
process.exit(bad ? 1 : 0);
