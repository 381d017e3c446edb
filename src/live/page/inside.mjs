/* SPDX-License-Identifier: MIT */
/* Scene 9: the inside of one contact. It is pushed sideways, then rolls on under the same push. */
import {short} from './draw.mjs';
import {word} from './words.mjs';

const PUSH = 60, ROLL = 240, ROLLER = .01; /* steps of both parts; radius of the rollers [m] */

export const insideScene = {
    id: 'inside',
    seconds: (PUSH + ROLL) / 50,
    pace: 1,
    controls: [
        {key: 'q', name: 'Q/μP', unit: '', min: -1, max: 1, step: .01, value: .6},
        {key: 'far', name: 'roll', unit: 'a', min: -8, max: 8, step: .5, value: 4},
        {key: 'press', name: 'P', unit: 'kN/m', min: 1, max: 50, step: 1, value: 10},
        {key: 'mu', name: 'μ', unit: '', min: .05, max: 1, step: .01, value: .3},
    ],
    open: (engine, s) => engine.inside(insideScene.text(s)),
    text: s =>
        `# ${word('scene.inside.title')}\nkind: patch\nbodies: {R1: ${ROLLER} m, R2: ${
            ROLLER} m, E: 70 GPa, nu: 0.3}\nmu: ${s.mu}\nsolver: half-plane\nelements: 100\nLambda: 4.5\npath:\n` +
        `  - {force: ${s.press} kN/m, tangential: ${s.q}*mu*P, steps: ${PUSH}}\n` +
        `  - {force: P, tangential: ${s.q}*mu*P, roll: ${s.far}*a, steps: ${
            ROLL}}\noutput: {frames: 60, snapshots: 12}\n`,
    begin: () => ({}),
    /* Lengths in a, tractions in mu p0. */
    draw(p, {world}, s, r) {
        const n = r.now, all = world.elements(), top = s.mu * 2 * s.press * 1e3 / (Math.PI * n.a || 1);
        const up = s.q < 0 ? -1 : 1;
        p.view(0, up > 0 ? .1 : -.35, 1.45, 1.05);
        const hill = Array.from({length: 81}, (_, k) => {
            const x = -1 + k / 40;
            return [x, up * Math.sqrt(Math.max(0, 1 - x * x))];
        });
        p.path([[-1.4, 0], [1.4, 0]], p.line, .06);
        p.path(hill, p.faint, .08);
        p.text('μ p', .78, .78 * up, {align: 'left', colour: p.faint});
        if (n.n && n.steps) {
            if (r.tell) this.zones(p, all, n, top);
            p.path(all.map(e => [e.x / n.a, e.tau / top]), p.ink, .16);
        }
        this.ground(p, n, up > 0 ? -.75 : -1.2);
        if (!r.tell) return;
        const x = p.px(-.2), y = p.py(-.2 * up);
        this.hatch(p, x, y - .5 * p.em, 1.4 * p.em, p.em);
        p.label(word('inside.sticks'), x + 1.8 * p.em, y);
        p.c.fillStyle = p.slide, p.c.fillRect(x, y + up * 1.5 * p.em - .5 * p.em, 1.4 * p.em, p.em);
        p.label(word('inside.slips'), x + 1.8 * p.em, y + up * 1.5 * p.em);
    },
    /* Below the traction: hatched where it sticks, coloured where it slips. */
    zones(p, all, n, top) {
        const wide = 2 / all.length * p.scale;
        let from = null;
        for (const [i, e] of [...all.entries(), [all.length, null]]) {
            const sticks = e && !e.side;
            if (e && e.side) {
                const y = p.py(e.tau / top);
                p.c.fillStyle = p.slide;
                p.c.fillRect(p.px(e.x / n.a) - wide / 2, Math.min(y, p.py(0)), wide + .5, Math.abs(y - p.py(0)));
            }
            if (sticks && from === null) from = i;
            if (sticks || from === null) continue;
            p.c.save(), p.c.beginPath(), p.c.moveTo(p.px(all[from].x / n.a) - wide / 2, p.py(0));
            for (let k = from; k < i; k++) p.c.lineTo(p.px(all[k].x / n.a), p.py(all[k].tau / top));
            p.c.lineTo(p.px(all[i - 1].x / n.a) + wide / 2, p.py(0)), p.c.closePath(), p.c.clip();
            this.hatch(p, p.px(-1), p.py(1), 2 * p.scale, 2 * p.scale);
            p.c.restore();
            from = null;
        }
    },
    hatch(p, x, y, w, h) {
        const c = p.c, gap = .45 * p.em;
        c.save(), c.beginPath(), c.rect(x, y, w, h), c.clip();
        c.beginPath();
        for (let k = -h; k < w; k += gap) c.moveTo(x + k, y + h), c.lineTo(x + k + h, y);
        c.strokeStyle = p.faint, c.lineWidth = .06 * p.em, c.stroke(), c.restore();
    },
    /* Marks of the material that runs through the contact. */
    ground(p, n, y) {
        const run = n.a ? n.u_roll / n.a : 0;
        for (let k = -7; k <= 7; k++) {
            const x = .2 * k + run - .2 * Math.round(run / .2), strong = (k - Math.round(run / .2)) % 5 === 0;
            p.path([[x, y], [x, y + (strong ? .1 : .05)]], strong ? p.ink : p.faint, .1);
        }
        if (n.rolls) p.arrow(-.15 * Math.sign(n.rolls), y + .16, .3 * Math.sign(n.rolls), 0, p.roll);
    },
    read({world}, s) {
        const n = world.state(), a = n.a || NaN, q = Math.abs(s.q);
        const carter = Math.sign(s.q) * s.mu * a / (ROLLER / 2) * (1 - Math.sqrt(1 - q)), percent = x => short(100 * x);
        const rolled = Math.abs(n.u_roll / a), full = q === 1;
        return {
            contacts: [],
            scale: 1,
            now: n,
            lines: [
                ['Q/μP', short(n.q)], [word('inside.share'), `${percent(n.steps ? 1 - n.stick / (2 * a) : NaN)} %`],
                [word('inside.pushed'), `${short(1e6 * n.u_slide)} µm`],
                [word('inside.rolled'), `${short(n.u_roll / a)} a`],
                [word('inside.creepage'), `${percent(n.rolls ? n.creepage : NaN)} %`],
                [word('inside.carter'), `${percent(carter)} %`]
            ],
            sentence: word('inside.' + (!n.steps                  ? 'start'
                                        : full && n.steps >= PUSH ? 'full'
                                        : !n.rolls                ? 'push'
                                        : rolled < 3              ? 'begins'
                                                                  : 'steady'))
        };
    },
};
