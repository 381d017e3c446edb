/* SPDX-License-Identifier: MIT */
/* Scene 0: one wheel on a floor; chalk on both surfaces. And the wheel with its chalk, which other scenes draw too. */
import {lampOf} from './gauge.mjs';
import {short} from './draw.mjs';
import {word} from './words.mjs';

export const WHEEL = .25; /* radius [m] */
const MARK = .1;          /* from one mark to the next, on floor and rim [m] */

/* A prescribed wheel on the floor. It overlaps by a thousandth of a millimetre, so that it touches. */
export function wheelText(x, vx, spin) {
    return `  - {radius: ${WHEEL} m, x: ${x} m, y: radius - 1 um, vx: ${vx} m/s, spin: ${
        spin} rad/s, motion: prescribed}\n`;
}

export function floorText(disks, seconds, title) {
    return `# ${title}\nkind: bodies\ntime_end: ${
               seconds} s\ncontact: {k_n: 1 MPa, friction: none, rolling: none}\nstep: {dt: 1 ms}\n` +
           `disks:\n${disks}walls:\n  - {nx: 0, ny: 1}\noutput: {frames: 100, rows: 101, contacts: 11}\n`;
}

/* The motion of disk i over the floor, for the definitions. */
export function floorMotion(d) {
    return {R1: Infinity, R2: d.radius, x1: d.x, y1: 0, x2: d.x, y2: d.y, vx2: d.vx, vy2: d.vy, w2: d.spin};
}

/* A wheel, its spokes, numbered marks on its rim, and those that it left on the floor. Chalk: the stretch of floor and
 * the stretch of rim that have been in contact since the start. */
export function drawWheel(p, d, start, {vs, vr, scale, tell, chalk = true}) {
    const lamp = lampOf(vs, vr, scale), floor = d.x - start.x, rim = d.angle - start.angle, R = d.radius;
    const marks = Math.round(2 * Math.PI * R / MARK), step = 2 * Math.PI / marks;
    p.path([[d.x - 20 * R, 0], [d.x + 20 * R, 0]], p.ink, .1);
    for (let k = Math.floor((d.x - 8 * R) / MARK); k * MARK < d.x + 8 * R; k++) {
        p.path([[k * MARK, 0], [k * MARK, k % 5 ? -.02 : -.04]], p.faint, .08);
        if (k % 5 === 0) p.text(short(k * MARK - start.x), k * MARK, -.075, {size: .8, colour: p.faint});
    }
    p.circle(d.x, d.y, R, {fill: p.fill, stroke: p.ink});
    for (let k = 0; k < marks; k++) {
        const a = d.angle - Math.PI / 2 + k * step, c = Math.cos(a), s = Math.sin(a), long = k % 5 ? .93 : .86;
        p.path([[d.x + R * c, d.y + R * s], [d.x + long * R * c, d.y + long * R * s]], p.faint, .08);
    }
    for (let k = 0; k < 3; k++) {
        const a = d.angle + k * Math.PI * 2 / 3 + Math.PI / 2;
        p.path([[d.x, d.y], [d.x + .8 * R * Math.cos(a), d.y + .8 * R * Math.sin(a)]], k ? p.line : p.ink, k ? .2 : .3);
    }
    if (chalk) {
        p.path([[start.x, -.008], [d.x, -.008]], p.ink, .35);
        const shown = Math.max(-2 * Math.PI, Math.min(2 * Math.PI, rim));
        if (shown)
            p.arc(d.x, d.y, .985 * R, shown > 0 ? -Math.PI / 2 : -Math.PI / 2 + shown,
                  shown > 0 ? -Math.PI / 2 + shown : -Math.PI / 2, p.ink, .35);
        const below = p.py(-.1) + .9 * p.em;
        p.label(word('rim.floorChalk', {length: short(Math.abs(floor))}), p.px(d.x), below, {align: 'center'});
        p.label(word('rim.rimChalk', {length: short(Math.abs(rim * R))}), p.px(d.x), below + 1.2 * p.em,
                {align: 'center'});
    }
    if (!tell) return;
    p.label(word('lamp.' + lamp), p.px(d.x), p.py(-.1) + (chalk ? 3.4 : .9) * p.em,
            {align: 'center', bold: true, size: 1.1});
    if (lamp === 'SLIDES' || lamp === 'BOTH') p.arrow(d.x - .12, .03, .24, 0, p.slide, {both: true});
    if (lamp === 'ROLLS' || lamp === 'BOTH') p.circle(d.x, 0, .018, {fill: p.roll});
}

/* The arrow of the velocity at the centre, and that of the spin: of the rim's top against the centre. */
export const ARROW = .35; /* metres of arrow for 1 m/s */
export function drawMotion(p, d) {
    p.arrow(d.x, d.y, ARROW * d.vx, 0, p.ink);
    p.arrow(d.x, d.y + d.radius, -ARROW * d.spin * d.radius, 0, p.faint);
    if (d.vx) p.text('v', d.x + ARROW * d.vx + .04 * Math.sign(d.vx), d.y + .03);
    if (d.spin)
        p.text('R ω', d.x - ARROW * d.spin * d.radius - .06 * Math.sign(d.spin), d.y + d.radius + .03,
               {colour: p.faint});
}

export const rimScene = {
    id: 'rim',
    seconds: 4,
    pace: 1,
    controls: [
        {key: 'v', name: 'v', unit: 'm/s', min: -1, max: 1, step: .01, value: .6},
        {key: 'w', name: 'ω', unit: 'rad/s', min: -4, max: 4, step: .01, value: -1},
    ],
    text: s => floorText(wheelText(0, s.v, s.w), rimScene.seconds, word('scene.rim.title')),
    begin: world => ({start: world.disk(0)}),
    /* While it runs, a new motion goes on from here: the chalk starts anew. */
    draw(p, {world, memory}, s, r) {
        const d = world.disk(0);
        p.view(d.x, .17, .75, .45);
        drawWheel(p, d, memory.start, {...r.contacts[0], ...r});
        drawMotion(p, d);
    },
    handles({world}, s) {
        const d = world.disk(0);
        return [
            {key: 'v', x: d.x + ARROW * s.v, y: d.y, value: x => (x - d.x) / ARROW},
            {key: 'w', x: d.x - ARROW * s.w * WHEEL, y: d.y + WHEEL, value: x => -(x - d.x) / ARROW / WHEEL}
        ];
    },
    read({world, memory, engine}) {
        const d = world.disk(0), definitions = engine.measure(floorMotion(d));
        const vs = definitions.sliding.wang, vr = definitions.rolling.wang, scale = 1;
        const slid = Math.abs((d.x - memory.start.x) + (d.angle - memory.start.angle) * d.radius);
        return {
            contacts: [{vs, vr}],
            scale,
            definitions,
            lines: [[word('rim.slid'), `${short(slid)} m`]],
            sentence: word('rim.' + lampOf(vs, vr, scale))
        };
    },
};
