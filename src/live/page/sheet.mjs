/* SPDX-License-Identifier: MIT */
/* What is printed: of each scene its question and a still, the answers on the last page. */
import {Painter} from './draw.mjs';
import {element} from './gauge.mjs';
import {SCENES} from './show.mjs';
import {word} from './words.mjs';

const SOME = .3; /* of its time, so that there is something to see */

/* The picture of now where the scene runs; of any other a run of its own. Readings stay covered. */
function still(canvas, app, scene) {
    const p = new Painter(canvas), state = app.states.get(scene.id);
    let run = app.run;
    if (run?.scene !== scene) {
        const world = scene.open ? scene.open(app.engine, state) : app.engine.open(3, scene.text(state));
        run = {scene, world, engine: app.engine, beside: null};
        run.memory = scene.begin(world, state, null);
        for (let k = 0; k < 20; k++)
            world.step(scene.slow ? 100 : Math.floor(SOME * scene.seconds / world.dt / 20)), scene.after?.(run);
    }
    const r = scene.read(run, state);
    r.tell = false;
    p.begin();
    scene.draw(p, run, state, r);
}

export function makeSheet(app, box) {
    const title = (s, i) => `${i + 1} ${word(`scene.${s.id}.title`)}`, answers = s => word(`scene.${s.id}.answers`);
    document.documentElement.classList.add('paper');
    box.replaceChildren(element('h1', {}, word('ui.title')));
    for (const [i, s] of SCENES.entries()) {
        const canvas = element('canvas');
        box.append(element('section', {}, element('h2', {}, title(s, i)),
                           element('p', {}, word(`scene.${s.id}.question`)), canvas,
                           element('p', {}, ...answers(s).map(a => element('span', {}, `☐ ${a}`)))));
        try {
            still(canvas, app, s);
        } catch (e) {
            canvas.replaceWith(element('p', {}, e.message));
        }
    }
    box.append(element(
        'section', {class: 'last'}, element('h2', {}, word('ui.answers')),
        ...SCENES.map((s, i) => element('p', {}, element('b', {}, `${title(s, i)}: `),
                                        answers(s)[word(`scene.${s.id}.right`)], '. ', word(`scene.${s.id}.reveal`)))));
    document.documentElement.classList.remove('paper');
}
