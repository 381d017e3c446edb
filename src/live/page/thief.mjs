/* SPDX-License-Identifier: MIT */
/* Scene 6: a closed cycle of one contact. Some laws of rolling resistance make energy in it. */
import {short} from './draw.mjs';
import {word} from './words.mjs';

const SMALL = .1, THIN = 1e-4, STIFF = 1e5; /* R1 [m]; overlap [m]; k_r [Pa] */
const LOOP = 4, LOOPS = 10;                 /* [s]: a leg takes a second */

/* The bound of rolling is far away: it is a spring all along. */
export function thiefLaws(s) {
    return `k_n: 1 GPa, friction: none, rolling: ${s.thiefLaw}, rolling_velocity: ${s.thiefBy}, mu_r: 1, k_r: ${
        STIFF} Pa`;
}

/* Radii and legs in metres and radians. */
export function thiefPair(s) {
    return {R1: SMALL, R2: SMALL * s.ratio, overlap: THIN, du: s.du / 1000, dtheta: s.dtheta};
}

/* Of [Wang2015 eq. 28] with the velocity of Bagi and Kuhn. By alonso-* nothing rolls here: the rims never run the same
 * way. A passive spring may take energy. */
function perLoop(s) {
    const {R1, R2, overlap, du, dtheta} = thiefPair(s);
    if (s.thiefLaw === 'wang-spring' && s.thiefBy === 'bagi-kuhn')
        return STIFF * R1 * R2 / (R1 + R2) * (R2 - R1) / (2 * (R1 + R2 - overlap)) * du * dtheta;
    return s.thiefLaw === 'passive-spring' && s.thiefBy === 'bagi-kuhn' ? NaN : 0;
}

const thiefLegs = app => {
    const {world} = app.run;
    return {world, to: n => { app.playing = false, app.target = n / (LOOP * LOOPS) - 1e-9; }};
};

export const thiefScene = {
    id: 'thief',
    seconds: LOOP * LOOPS,
    pace: 4,
    controls: [
        {
            key: 'thiefLaw',
            name: 'law',
            choices: ['wang-spring', 'conjugate-spring', 'passive-spring'],
            value: 'wang-spring'
        },
        {
            key: 'thiefBy',
            name: 'definition',
            choices: ['wang', 'bagi-kuhn', 'alonso-min', 'alonso-mean'],
            value: 'bagi-kuhn'
        },
        {key: 'ratio', name: 'R₂/R₁', unit: '', min: 1, max: 5, step: .1, value: 2},
        {key: 'du', name: 'Δu', unit: 'mm', min: -50, max: 50, step: 1, value: 30},
        {key: 'dtheta', name: 'Δθ', unit: 'rad', min: -.5, max: .5, step: .01, value: .3},
    ],
    actions: [
        {
            name: 'leg',
            run(app) {
                const {world, to} = thiefLegs(app);
                to(Math.floor(world.steps / world.leg) + 1);
            }
        },
        {
            name: 'loop',
            run(app) {
                const {world, to} = thiefLegs(app);
                to(LOOP * (Math.floor(world.steps / world.leg / LOOP) + 1));
            }
        }
    ],
    open: (engine, s) => engine.cycle(thiefLaws(s), thiefPair(s)),
    /* The same cycle as a case: slide and roll of an observer who goes around with disk 2. */
    text(s) {
        const {R1, R2, du, dtheta} = thiefPair(s), L = R1 + R2 - THIN;
        const leg = (slide, roll) => `  - {force: ${1e9 * THIN} N/m, slide: ${slide} m, roll: ${roll} m, steps: 100}\n`;
        const on = leg((R1 + R2) / L * du, (R2 - R1) / (2 * L) * du), turn = leg(R1 * dtheta, -R1 * dtheta / 2);
        const back = leg(-(R1 + R2) / L * du, -(R2 - R1) / (2 * L) * du), undo = leg(-R1 * dtheta, R1 * dtheta / 2);
        return `# ${word('scene.thief.title')}\nkind: contact\nbodies: {R1: ${R1} m, R2: ${
                   R2} m, E: 70 GPa, nu: 0.3}\nlaws:\n  - {${thiefLaws(s)}}\npath:\n` +
               (on + turn + back + undo).repeat(LOOPS);
    },
    begin: () => ({}),
    draw(p, {world}, s, r) {
        const whole = p.box, {R1, R2} = thiefPair(s), q = world.state(), L = R1 + R2 - THIN, reach = R1 + 2 * R2;
        const x = L * Math.cos(q.beta), y = L * Math.sin(q.beta), leg = Math.floor((world.steps - .5) / world.leg) % 4;
        p.view(R2, 0, .62 * reach, .62 * reach, {x: whole.x, y: whole.y, w: .5 * whole.w, h: whole.h});
        for (const [cx, cy, R, a, name] of [[0, 0, R1, q.theta1, '1'], [x, y, R2, 0, '2']]) {
            p.circle(cx, cy, R, {fill: p.fill, stroke: p.ink});
            for (let k = 0; k < 12; k++) {
                const t = a + k * Math.PI / 6, long = k ? .9 : .4;
                p.path(
                    [
                        [cx + long * R * Math.cos(t), cy + long * R * Math.sin(t)],
                        [cx + R * Math.cos(t), cy + R * Math.sin(t)]
                    ],
                    k ? p.faint : p.ink, k ? .08 : .2);
            }
            p.text(name, cx - .2 * R, cy - .2 * R, {bold: true});
        }
        p.circle(L, 0, .02 * reach, {stroke: p.faint});
        if (world.steps) p.label(word('thief.legs')[leg], p.px(R2), whole.y + p.em, {align: 'center', bold: true});
        const view = [p.x0, p.y0, p.scale], size = r.tell ? Math.max(1e-3, ...world.work.map(Math.abs)) : 1,
              points = world.work.map((work, k) => [k / (10 * LOOP), work]);
        p.chart({x: whole.x + .5 * whole.w, y: whole.y, w: .5 * whole.w, h: whole.h}, {
            x: [0, LOOPS],
            y: [-1.1 * size, 1.1 * size],
            xName: word('thief.loops'),
            yName: word('thief.work'),
            curves: r.tell ? [{points: [[0, 0], [LOOPS, 0]], colour: p.line}, {points, colour: p.ink}] : []
        });
        [p.x0, p.y0, p.scale] = view, p.box = whole;
    },
    read({world}, s) {
        const ends = world.work.filter((_, k) => k % (10 * LOOP) === 0), n = ends.length - 1, made = ends[n],
              last = n ? made - ends[n - 1] : NaN, exact = perLoop(s);
        const {R1, du, dtheta} = thiefPair(s), small = 1e-6 * STIFF * (du ** 2 + (R1 * dtheta) ** 2);
        return {
            contacts: [],
            scale: 1,
            made,
            last,
            lines: [
                [word('thief.loops'), String(n)], [word('thief.total'), `${short(world.state().work)} J/m`],
                [word('thief.each'), `${short(Math.abs(last) < small ? 0 : last)} J/m`],
                [word('thief.exact'), `${short(exact)} J/m`]
            ],
            sentence: word('thief.' + (!n              ? 'wait'
                                       : made > small  ? 'made'
                                       : made < -small ? 'lost'
                                                       : 'none'))
        };
    },
};
