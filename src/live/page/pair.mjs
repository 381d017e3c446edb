/* SPDX-License-Identifier: MIT */
/* Scene 2: two wheels touching. Their spins and the turning of the pair: find rigid rotation, rolling, sliding. */
import {lampOf} from './gauge.mjs';
import {short} from './draw.mjs';
import {word} from './words.mjs';

const OVERLAP = 1e-6; /* [m]: they touch */
const HIT = .02;      /* of the fastest rim: what counts as found */

/* Slides only, rolls only, or neither while all turn. */
function found(s, vs, vr) {
    const fast = Math.max(Math.abs(s.w1) * s.R1, Math.abs(s.w2) * s.R2, Math.abs(s.turn) * (s.R1 + s.R2));
    const still = v => Math.abs(v) <= HIT * fast;
    if (fast < .05) return null;
    return still(vs) ? still(vr) ? 'rigid' : 'rolling' : still(vr) ? 'sliding' : null;
}

export const pairScene = {
    id: 'pair',
    seconds: 12,
    pace: 1,
    controls: [
        {key: 'w1', name: 'ω₁', unit: 'rad/s', min: -3, max: 3, step: .01, value: 1},
        {key: 'w2', name: 'ω₂', unit: 'rad/s', min: -3, max: 3, step: .01, value: .5},
        {key: 'turn', name: 'pair dβ/dt', unit: 'rad/s', min: -3, max: 3, step: .01, value: 0},
        {key: 'R1', name: 'R₁', unit: 'm', min: .05, max: .4, step: .005, value: .25},
        {key: 'R2', name: 'R₂', unit: 'm', min: .05, max: .4, step: .005, value: .15},
        {key: 'ride', name: 'ride', choices: ['no', 'yes'], value: 'no', free: true},
    ],
    text: s => `# ${word('scene.pair.title')}\nkind: bodies\ntime_end: ${pairScene.seconds} s\n` +
               'contact: {k_n: 1 MPa, friction: none, rolling: none}\nstep: {dt: 1 ms}\ndisks:\n' +
               `  - {radius: ${s.R1} m, x: 0, y: 0, spin: ${s.w1} rad/s, motion: prescribed}\n` +
               `  - {radius: ${s.R2} m, x: disks.0.radius + radius - ${OVERLAP} m, y: 0, spin: ${
                   s.w2} rad/s, motion: orbit, orbit: ${s.turn} rad/s}\n` +
               'output: {frames: 100, rows: 101, contacts: 11}\n',
    begin: (world, s, before) => ({hits: before?.hits ?? []}),
    draw(p, {world}, s, r) {
        const a = world.disk(0), b = world.disk(1), beta = Math.atan2(b.y - a.y, b.x - a.x);
        const back = s.ride === 'yes' ? -beta : 0,
              turn = ([x, y]) => [x * Math.cos(back) - y * Math.sin(back), x * Math.sin(back) + y * Math.cos(back)];
        const reach = s.R1 + 2 * s.R2 + .05, [vs, vr] = [r.contacts[0].vs, r.contacts[0].vr],
              lamp = lampOf(vs, vr, r.scale);
        p.view(0, 0, reach, reach);
        for (const [d, name] of [[a, '1'], [b, '2']]) {
            const [x, y] = turn([d.x, d.y]), marks = Math.round(2 * Math.PI * d.radius / .05);
            p.circle(x, y, d.radius, {fill: p.fill, stroke: p.ink});
            for (let k = 0; k < marks; k++) {
                const t = d.angle + back + 2 * Math.PI * k / marks, long = k ? .93 : .6;
                p.path(
                    [
                        [x + long * d.radius * Math.cos(t), y + long * d.radius * Math.sin(t)],
                        [x + d.radius * Math.cos(t), y + d.radius * Math.sin(t)]
                    ],
                    k ? p.faint : p.ink, k ? .08 : .25);
            }
            p.text(name, x, y, {bold: true});
        }
        const [x, y] = turn([a.radius * Math.cos(beta), a.radius * Math.sin(beta)]), n = beta + back;
        if (!r.tell) return;
        const off = Math.min(a.radius, b.radius) + .06;
        p.text(word('lamp.' + lamp), x + off * Math.sin(n), y - off * Math.cos(n), {bold: true, size: 1.1});
        if (lamp === 'SLIDES' || lamp === 'BOTH')
            p.arrow(x + .08 * Math.sin(n), y - .08 * Math.cos(n), -.16 * Math.sin(n), .16 * Math.cos(n), p.slide,
                    {both: true});
        if (lamp === 'ROLLS' || lamp === 'BOTH') p.circle(x, y, .018, {fill: p.roll});
    },
    handles({world}, s) {
        if (s.ride === 'yes') return [];
        const b = world.disk(1), t = Math.atan2(b.y, b.x) + Math.PI / 2;
        return [
            {key: 'R1', x: -s.R1, y: 0, value: (x, y) => Math.hypot(x, y)}, {
                key: 'R2',
                x: b.x + s.R2 * Math.cos(t),
                y: b.y + s.R2 * Math.sin(t),
                value: (x, y) => Math.hypot(x - b.x, y - b.y)
            }
        ];
    },
    read({world, engine, memory}, s) {
        const a = world.disk(0), b = world.disk(1), scale = 1;
        const definitions =
            engine.measure({R1: s.R1, R2: s.R2, w1: a.spin, x2: b.x, y2: b.y, vx2: b.vx, vy2: b.vy, w2: b.spin});
        const vs = definitions.sliding.wang, vr = definitions.rolling.wang, hit = found(s, vs, vr);
        if (hit && !memory.hits.includes(hit)) memory.hits.push(hit);
        const tasks = ['rigid', 'rolling', 'sliding'].map(
            k => `${memory.hits.includes(k) ? '✓' : '○'} ${word('pair.tasks.' + k)}`);
        return {
            contacts: [{vs, vr}],
            scale,
            definitions,
            bars: [[word('pair.rigid'), s.turn, 3, 'rad/s']],
            lines: tasks.map(t => [word('pair.task'), t]),
            sentence: hit ? word('pair.found.' + hit) : word('pair.none', {vs: short(vs), vr: short(vr)})
        };
    },
};
