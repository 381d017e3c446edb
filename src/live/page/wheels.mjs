/* SPDX-License-Identifier: MIT */
/* Scene 1: three wheels with the same speed: one rolls, one skids, one spins on the spot. */
import {drawMotion, drawWheel, floorMotion, floorText, WHEEL, wheelText} from './rim.mjs';
import {word} from './words.mjs';

const WHEELS_SCALE = 1;

function contacts(world, engine) {
    return [0, 1, 2].map(i => {
        const m = engine.measure(floorMotion(world.disk(i)));
        return {name: word('wheels.names')[i] + ':', vs: m.sliding.wang, vr: m.rolling.wang, definitions: m};
    });
}

export const wheelsScene = {
    id: 'wheels',
    seconds: 4,
    pace: 1,
    controls: [
        {key: 'v', name: 'v', unit: 'm/s', min: -1, max: 1, step: .01, value: .5},
        {key: 'w', name: 'ω', unit: 'rad/s', min: -4, max: 4, step: .01, value: -2},
    ],
    text: s => floorText(wheelText(0, s.v, -s.v / WHEEL) + wheelText(20, s.v, 0) + wheelText(40, 0, s.w),
                         wheelsScene.seconds, word('scene.wheels.title')),
    begin: world => ({start: [0, 1, 2].map(i => world.disk(i))}),
    draw(p, {world, memory}, s, r) {
        const whole = p.box;
        for (let i = 0; i < 3; i++) {
            const d = world.disk(i);
            p.view(d.x, .17, .42, .45, {x: whole.x + i * whole.w / 3, y: whole.y, w: whole.w / 3, h: whole.h});
            p.c.save();
            p.c.beginPath(), p.c.rect(p.box.x, p.box.y, p.box.w, p.box.h), p.c.clip();
            drawWheel(p, d, memory.start[i], {...r.contacts[i], ...r});
            drawMotion(p, d);
            p.label(word('wheels.names')[i], p.box.x + p.box.w / 2, p.box.y + p.em, {align: 'center', bold: true});
            p.c.restore();
        }
        p.box = whole;
    },
    read({world, engine}) {
        const all = contacts(world, engine);
        return {contacts: all, scale: WHEELS_SCALE, definitions: all[2].definitions, sentence: word('wheels.sentence')};
    },
};
