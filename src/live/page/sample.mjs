/* SPDX-License-Identifier: MIT */
/* Scene 10: the biaxial test of cases/biaxial.yaml, 400 disks, while it runs. */
import {short} from './draw.mjs';
import {word} from './words.mjs';

const STRAIN = .2;
/* Creep as in cases/biaxial-creep.yaml, on the spring of cases/biaxial.yaml, so that only creep differs. */
const CREEP = {
    no: 'coulomb-spring',
    yes: 'dahlberg-alfredsson\n  E_star: 2*3.6*k_n/pi\n  creep_roll: wang'
};

/* Which contact lies nearest to a point of the world. */
function nearest(touches, x, y) {
    let best = null, least = Infinity;
    for (let i = 0; i < touches.n; i++) {
        const at = touches.stride * i + 1, far = Math.hypot(touches.numbers[at] - x, touches.numbers[at + 1] - y);
        if (far < least) least = far, best = {a: touches.a(i), b: touches.b(i)};
    }
    return best;
}

/* Of the contacts of disks with disks: mean squares, and how many slide, roll more than they slide, turn as gears. */
function shares(touches) {
    const out = {n: 0, slide: 0, roll: 0, gears: 0, rms: 0, force: 0};
    for (let i = 0; i < touches.n; i++) {
        if (touches.a(i) < 0) continue;
        const at = touches.stride * i + 1, x = touches.numbers, vs = x[at + 9], vr = x[at + 10];
        out.n++;
        out.slide += x[at + 13] > .999, out.roll += Math.abs(vr) > Math.abs(vs),
            out.gears += x[at + 11] * x[at + 12] < 0;
        out.rms += vs * vs + vr * vr, out.force += x[at + 5];
    }
    out.rms = Math.sqrt(out.rms / (out.n || 1)), out.force /= out.n || 1;
    return out;
}

/* Line of a contact: its colour and width as a share of the mean radius, by what is shown. */
function look(p, mode, x, at, all) {
    const vs = Math.abs(x[at + 9]), vr = Math.abs(x[at + 10]), force = Math.min(4, x[at + 5] / all.force);
    const speed = Math.min(1, Math.hypot(vs, vr) / (2 * all.rms || 1));
    switch (mode) {
    case 'force': return [p.ink, .22 * force];
    case 'friction': return [p.ink, .6 * x[at + 13]];
    case 'sliding': return [p.slide, .7 * Math.min(1, vs / (2 * all.rms || 1))];
    case 'rolling': return [p.roll, .7 * Math.min(1, vr / (2 * all.rms || 1))];
    case 'spin': return [p.line, .06];
    default: return speed < .05 ? [p.faint, .08] : [vs > vr ? p.slide : p.roll, .1 + .6 * speed];
    }
}

const RADIUS = .00114; /* mean [m] */

function drawSample(p, world, mode, memory) {
    if (!world.steps && (mode === 'both' || mode === 'sliding' || mode === 'rolling'))
        mode = 'force'; /* nothing moves yet */
    const pen = RADIUS * p.scale / p.em;
    const disks = world.disks(), touches = world.touches(), x = touches.numbers, all = shares(touches);
    let spin = 0;
    for (let i = 0; i < world.count; i++) spin += disks[11 * i + 5] ** 2;
    spin = Math.sqrt(spin / world.count) || 1;
    for (let i = 0; i < world.count; i++) {
        const at = 11 * i, R = disks[at + 9], a = disks[at + 2];
        p.circle(disks[at], disks[at + 1], R, {fill: p.fill, stroke: p.line, width: .04});
        if (mode === 'spin') {
            p.c.globalAlpha = Math.min(1, Math.abs(disks[at + 5]) / (3 * spin));
            p.circle(disks[at], disks[at + 1], R, {fill: p.ink});
            p.c.globalAlpha = 1;
        }
        p.path([[disks[at], disks[at + 1]], [disks[at] + .8 * R * Math.cos(a), disks[at + 1] + .8 * R * Math.sin(a)]],
               p.line, .05);
    }
    for (let i = 0; i < touches.n; i++) {
        /* The walls are smooth: what slides along them says nothing. */
        const at = touches.stride * i + 1, a = touches.a(i), b = touches.b(i),
              [colour_, width] = look(p, a < 0 ? 'force' : mode, x, at, all);
        if (width < .03) continue;
        const from = a < 0 ? [x[at], x[at + 1]] : [disks[11 * a], disks[11 * a + 1]];
        p.path([from, [disks[11 * b], disks[11 * b + 1]]], colour_, width * pen);
        if (memory.follow && memory.follow.a === a && memory.follow.b === b)
            p.circle(x[at], x[at + 1], RADIUS, {stroke: p.ink, width: .15});
    }
    return all;
}

export const sampleScene = {
    id: 'sample',
    stepsPerSecond: 30000,
    slow: true,
    controls: [
        {key: 'mu', name: 'μ', unit: '', min: 0, max: 1, step: .01, value: .5, live: true},
        {key: 'mu_r', name: 'μ_r', unit: '', min: 0, max: 2, step: .01, value: .5, live: true},
        {
            key: 'definition',
            name: 'definition',
            choices: ['wang', 'bagi-kuhn', 'alonso-min', 'alonso-mean'],
            value: 'wang',
            live: true
        },
        {key: 'creep', name: 'creep', choices: ['no', 'yes'], value: 'no', live: true},
        {key: 'seed', name: 'seed', min: 1, max: 99, step: 1, value: 1},
        {
            key: 'beside',
            name: 'beside',
            choices: ['nothing', 'mu_r0', 'creep', 'wang', 'bagi-kuhn', 'alonso-min', 'alonso-mean'],
            value: 'nothing'
        },
        {
            key: 'show',
            name: 'show',
            choices: ['both', 'sliding', 'rolling', 'friction', 'force', 'spin'],
            value: 'both',
            free: true
        },
    ],
    text: s => `# ${word('scene.sample.title')}\nkind: biaxial\nseed: ${s.seed}\n` +
               'sample: {disks: 400, r_min: 0.76 mm, r_max: 1.52 mm, density: 2700 kg/m^3}\n' +
               'contact:\n  normal: linear\n  k_n: 160 MPa\n' +
               `  damping_ratio: 0.3\n  friction: ${CREEP[s.creep]}\n  mu: ${
                   s.mu}\n  k_t: 0.5*k_n\n  rolling: wang-spring\n  rolling_velocity: ${s.definition}\n` +
               `  mu_r: ${s.mu_r}\n  k_r: k_t\ncompaction: {pressure: 160 kPa, mu: 0}\n` +
               `shear: {lateral_pressure: 160 kPa, inertial_number: 1e-3, strain_end: ${
                   STRAIN}}\noutput: {frames: 20, rows: 400}\n`,
    /* The same packing with one thing changed; null: nothing beside it. */
    other(s) {
        if (s.beside === 'nothing') return null;
        const change = {mu_r0: {mu_r: 0}, creep: {creep: 'yes'}}[s.beside] ?? {definition: s.beside};
        return sampleScene.text({...s, ...change});
    },
    /* Three seeds one after the other; their curves stay. */
    actions: [
        {
            name: 'seeds',
            run(app) {
                const first = app.state.seed, seeds = [first, first + 1, first + 2].filter(k => k <= 99);
                app.queue = seeds.map(seed => ({seed}));
                app.next();
            }
        },
        {
            /* Rolling resistance and creep, each with and without, on one packing. */
            name: 'four',
            run(app) {
                app.queue = [[.5, 'no'], [.5, 'yes'], [0, 'no'], [0, 'yes']].map(([mu_r, creep]) => ({mu_r, creep}));
                app.next();
            }
        }
    ],
    begin(world, s, before) {
        const ghosts = before?.ghosts ?? [];
        if (before?.curve.length > 5) ghosts.push({points: before.curve, label: before.label});
        if (before?.besideCurve.length > 5) ghosts.push({points: before.besideCurve, label: before.besideLabel});
        const first = world.disks(), box = [Infinity, -Infinity, Infinity, -Infinity];
        for (let i = 0; i < world.count; i++) {
            const [x, y, R] = [first[11 * i], first[11 * i + 1], first[11 * i + 9]];
            box[0] = Math.min(box[0], x - R), box[1] = Math.max(box[1], x + R), box[2] = Math.min(box[2], y - R),
            box[3] = Math.max(box[3], y + R);
        }
        return {
            ghosts: ghosts.slice(-6),
            curve: [],
            besideCurve: [],
            besideLabel: word('choice.' + s.beside),
            box,
            last: world.biaxial(),
            follow: null,
            label: `μ ${short(s.mu)}, μ_r ${short(s.mu_r)}, ${s.definition}${
                s.creep === 'yes' ? `, ${word('control.creep')}` : ''}, ${s.seed}`
        };
    },
    after({world, beside, memory}) {
        memory.last = world.biaxial();
        if (world.steps) memory.curve.push([100 * memory.last.strain, memory.last.sinPhi]);
        if (beside?.steps)
            memory.besideLast = beside.biaxial(),
            memory.besideCurve.push([100 * memory.besideLast.strain, memory.besideLast.sinPhi]);
    },
    progress: ({memory}) => memory.last.strain / STRAIN,
    draw(p, {world, beside, memory}, s) {
        const whole = p.box, tall = whole.h > whole.w, w = tall ? whole.w : .56 * whole.w,
              h = tall ? .6 * whole.h : whole.h;
        const one = beside ? tall ? {w: w / 2, h} : {w, h: h / 2} : {w, h};
        const [x0, x1, y0, y1] = memory.box; /* it gets lower and wider */
        p.view((x0 + x1) / 2, (y0 + y1) / 2, .64 * (x1 - x0), .54 * (y1 - y0), {x: whole.x, y: whole.y, ...one});
        memory.shares = drawSample(p, world, s.show, memory);
        const sample = [p.x0, p.y0, p.scale];
        if (beside) {
            p.label('A', whole.x, whole.y + .7 * p.em, {bold: true});
            p.view((x0 + x1) / 2, (y0 + y1) / 2, .64 * (x1 - x0), .54 * (y1 - y0),
                   {x: whole.x + (tall ? w / 2 : 0), y: whole.y + (tall ? 0 : h / 2), ...one});
            drawSample(p, beside, s.show, {});
            p.label('B', p.box.x, p.box.y + .7 * p.em, {bold: true});
        }
        p.chart(tall ? {x: whole.x, y: whole.y + h, w: whole.w, h: whole.h - h}
                     : {x: whole.x + w, y: whole.y, w: whole.w - w, h: whole.h},
                {
                    x: [0, 100 * STRAIN],
                    y: [0, .8],
                    xName: word('sample.strain'),
                    yName: word('sample.sinPhi'),
                    curves: [
                        ...memory.ghosts.map(g => ({points: g.points, colour: p.line, name: g.label, width: .12})), {
                            points: memory.besideCurve,
                            colour: p.faint,
                            dash: true,
                            name: beside ? 'B ' + memory.besideLabel : ''
                        },
                        {points: memory.curve, colour: p.ink, name: beside ? 'A' : ''}
                    ]
                });
        [p.x0, p.y0, p.scale] = sample;
        p.box = whole;
    },
    click({world, memory}, x, y) {
        memory.follow = nearest(world.touches(), x, y);
    },
    read({world, memory}) {
        const all = memory.shares ?? shares(world.touches()), percent = k => `${Math.round(100 * k / (all.n || 1))} %`,
              out = {contacts: [], scale: 3 * all.rms || 1};
        const lines = [
            [word('sample.sinPhi'), short(memory.last.sinPhi)], [word('sample.voids'), short(memory.last.voidRatio)],
            [word('sample.slide'), percent(all.slide)], [word('sample.roll'), percent(all.roll)],
            [word('sample.gears'), percent(all.gears)]
        ];
        if (memory.besideLast) lines.splice(1, 0, [`${word('sample.sinPhi')} B`, short(memory.besideLast.sinPhi)]);
        const peak = points => short(Math.max(...points.map(k => k[1])));
        for (const g of memory.ghosts) lines.push([`${word('sample.peak')} ${g.label}`, peak(g.points)]);
        if (memory.follow) {
            const t = world.touches(), {a, b} = memory.follow,
                  i = Array.from({length: t.n}, (_, k) => k).find(k => t.a(k) === a && t.b(k) === b);
            const name = a < 0 ? `${word('sample.wall')} ${- 1 - a} – ${b}` : `${a} – ${b}`;
            if (i === undefined)
                lines.push([name, word('sample.open')]);
            else {
                const at = t.stride * i + 1;
                out.contacts.push({name, vs: t.numbers[at + 9], vr: t.numbers[at + 10]});
                lines.push([word('sample.used'), short(t.numbers[at + 13])]);
            }
        }
        return {...out, lines, sentence: memory.follow ? '' : word('sample.click')};
    },
};
