/* SPDX-License-Identifier: MIT */
/* Scene 8: a ring of N wheels that touch. The first one is driven: can the ring turn? */
import {lampOf} from './gauge.mjs';
import {short} from './draw.mjs';
import {word} from './words.mjs';

const R = .1, SPIN = 2, RIM = R * SPIN;
/* The springs of friction swing on by mu P/sqrt(k_t I) = 0.03 rad/s: less than 0.05 of RIM counts as still. */

export const gearsScene = {
    id: 'gears',
    seconds: 4,
    pace: .5,
    controls: [
        {key: 'n', name: 'N', unit: '', min: 3, max: 8, step: 1, value: 3},
        {key: 'mu', name: 'μ', unit: '', min: 0, max: 1, step: .01, value: .3}
    ],
    /* Each presses its neighbours by 2e-4 of its radius; all but the first turn freely about pins. */
    text(s) {
        const far = R * (1 - 1e-4) / Math.sin(Math.PI / s.n);
        const disk = k =>
            `  - {radius: ${R} m, density: 300 kg/m^3, x: ${far * Math.cos(2 * Math.PI * k / s.n)} m, y: ${
                far * Math.sin(2 * Math.PI * k / s.n)} m, ` +
            (k ? 'motion: pinned}\n' : `spin: ${SPIN} rad/s, motion: prescribed}\n`);
        return `# ${word('scene.gears.title')}\nkind: bodies\ntime_end: ${gearsScene.seconds} s\n` +
               `contact: {k_n: 1 MPa, k_t: 1 MPa, friction: coulomb-spring, mu: ${s.mu}, rolling: none}\ndisks:\n` +
               Array.from({length: s.n}, (_, k) => disk(k)).join('') +
               'output: {frames: 100, rows: 101, contacts: 11}\n';
    },
    begin: () => ({}),
    draw(p, {world}, s, r) {
        const reach = R / Math.sin(Math.PI / s.n) + 1.3 * R;
        p.view(0, 0, reach, reach);
        for (let k = 0; k < s.n; k++) {
            const d = world.disk(k);
            p.circle(d.x, d.y, R, {fill: p.fill, stroke: p.ink, width: k ? .08 : .2});
            for (let i = 0; i < 12; i++) {
                const a = d.angle + i * Math.PI / 6, long = i ? .9 : .5;
                p.path(
                    [
                        [d.x + long * R * Math.cos(a), d.y + long * R * Math.sin(a)],
                        [d.x + R * Math.cos(a), d.y + R * Math.sin(a)]
                    ],
                    i ? p.faint : p.ink, i ? .08 : .2);
            }
            p.text(k ? String(k + 1) : word('gears.driven'), d.x, d.y, {size: k ? 1 : .7});
        }
        if (!r.tell) return;
        for (const t of r.touches) {
            const lamp = lampOf(t.vs, t.vr, 50 * RIM);
            if (lamp === 'SLIDES' || lamp === 'BOTH')
                p.arrow(t.x + .4 * R * t.ny, t.y - .4 * R * t.nx, -.8 * R * t.ny, .8 * R * t.nx, p.slide, {both: true});
            if (lamp === 'ROLLS' || lamp === 'BOTH') p.circle(t.x, t.y, .1 * R, {fill: p.roll});
        }
    },
    read({world}, s) {
        const all = world.touches(), touches = [];
        let lost = 0;
        for (let i = 0; i < all.n; i++) {
            const x = all.numbers, at = all.stride * i + 1;
            touches.push({x: x[at], y: x[at + 1], nx: x[at + 2], ny: x[at + 3], vs: x[at + 9], vr: x[at + 10]});
            if (x[at + 13] > .999) lost += Math.abs(x[at + 6] * x[at + 9]);
        }
        const sliding = touches.filter(t => /SLIDES|BOTH/.test(lampOf(t.vs, t.vr, 50 * RIM))).length;
        return {
            contacts: [],
            touches,
            sliding,
            scale: RIM,
            lines: [
                [word('gears.sliding'), `${sliding} / ${touches.length}`], [word('gears.lost'), `${short(lost)} W/m`],
                [word('gears.last'), `${short(world.disk(s.n - 1).spin)} rad/s`]
            ],
            sentence: word(sliding ? 'gears.stuck' : 'gears.turns')
        };
    },
};
