/* SPDX-License-Identifier: MIT */
/* The page: scenes, transport, controls, keys. */
import {loadEngine} from './engine.mjs';
import {Painter, short} from './draw.mjs';
import {element, fillPanel} from './gauge.mjs';
import {defaults, fromAddress, limit, SCENES, toAddress} from './show.mjs';
import {makeSheet} from './sheet.mjs';
import {findTasks, TASKS} from './tasks.mjs';
import {word} from './words.mjs';

const SLOWER = [1, 1 / 2, 1 / 5, 1 / 20], BUDGET = 11; /* ms of a picture for computing; 16 are there */
const at = id => document.getElementById(id);

class App {
    constructor(engine) {
        this.engine = engine;
        this.painter = new Painter(at('picture'));
        this.speed = 0, this.playing = false, this.expert = false, this.debt = 0, this.told = 0;
        this.states = new Map(SCENES.map(s => [s.id, defaults(s)]));
        this.kept = new Map(); /* what a scene remembers over a reset: ghosts, hits */
        this.revealed = new Set();
        this.hits = new Map(SCENES.map(s => [s.id, new Set()])); /* tasks that were found */
        this.live = element('p', {'aria-live': 'polite', class: 'aside', style: 'position:absolute;left:-999em'});
        document.body.append(this.live);
        this.keys(), this.pointer();
        addEventListener('beforeprint', () => makeSheet(this, at('sheet')));
        addEventListener('afterprint', () => at('sheet').replaceChildren());
        addEventListener('hashchange', () => this.fromAddress());
        this.fromAddress();
        requestAnimationFrame(t => this.frame(t));
    }

    fromAddress() {
        const {scene, state, wrong} = fromAddress(location.hash);
        this.states.set(scene.id, state);
        this.choose(scene);
        if (wrong.length) this.notice(word('ui.badLink', {what: wrong.join(', ')}));
    }

    get state() {
        return this.states.get(this.scene.id);
    }
    get memory() {
        return this.run?.memory;
    }

    /* The next of several runs, one after the other. */
    next() {
        const values = this.queue?.shift();
        if (!values) return;
        Object.assign(this.state, values);
        this.building();
        this.reset(true);
    }

    choose(scene) {
        this.queue = [];
        this.keep();
        this.run = null, this.playing = false;
        this.scene = scene;
        this.building();
        this.reset();
    }

    keep() {
        if (this.run) this.kept.set(this.run.scene.id, this.run.memory);
    }

    notice(text, action) {
        const n = at('notice');
        n.hidden = !text;
        n.replaceChildren(text ?? '', ...(action ? [' ', action] : []));
    }

    /* A new world of the case as the controls are. A slow one first lets the page say so. */
    reset(play = false) {
        this.keep();
        this.run = null, this.playing = false, this.target = null, this.debt = 0;
        this.notice(null);
        const begin = () => {
            const scene = this.scene, text = scene.text(this.state);
            try {
                const world = scene.open ? scene.open(this.engine, this.state) : this.engine.open(0, text);
                const other = scene.other?.(this.state);
                this.run = {
                    scene,
                    world,
                    text,
                    engine: this.engine,
                    changed: false,
                    beside: other ? this.engine.open(1, other) : null
                };
                this.run.memory = scene.begin(world, this.state, this.kept.get(scene.id));
                scene.after?.(this.run);
                this.playing = play;
                this.notice(null);
            } catch (e) {
                this.failed(e);
            }
            this.address(), this.transport();
        };
        clearTimeout(this.pending);
        if (!this.scene.slow) return begin();
        this.notice(word('ui.packing'));
        this.pending = setTimeout(begin, 30);
    }

    /* The message of the command, and a way out. */
    failed(e) {
        this.playing = false, this.target = null;
        this.notice(e.message, element('button', {onclick: () => this.reset()}, word('ui.reset')));
    }

    progress() {
        if (!this.run) return 0;
        return this.scene.progress ? this.scene.progress(this.run) : this.run.world.time() / this.scene.seconds;
    }

    /* n steps at most, as long as the budget lasts; false at the end. */
    advance(n, budget = BUDGET) {
        const {world, beside} = this.run, until = performance.now() + budget,
                      chunk = Math.max(1, Math.min(n, this.scene.slow ? 25 : 200));
        let left = n;
        try {
            while (left > 0 && performance.now() < until && this.progress() < 1) {
                const few = Math.min(left, chunk);
                world.step(few), beside?.step(few), left -= few;
            }
            if (left < n) this.scene.after?.(this.run);
        } catch (e) {
            this.failed(e);
        }
        return left;
    }

    frame(now) {
        const elapsed = Math.min(.1, (now - (this.last ?? now)) / 1000);
        this.last = now;
        this.pictures = (this.pictures ?? 0) + 1;
        if (this.run && this.target !== null)
            this.chase();
        else if (this.run && this.playing) {
            const rate = this.scene.stepsPerSecond ?? this.scene.pace / this.run.world.dt;
            this.debt = Math.min(this.debt + elapsed * rate * SLOWER[this.speed], 2 * rate / 60);
            const n = Math.floor(this.debt);
            if (n) this.debt -= n - this.advance(n);
            if (this.progress() >= 1) this.playing = false, this.transport(), this.next();
        }
        if (this.run) this.draw(now);
        requestAnimationFrame(t => this.frame(t));
    }

    /* To where the scrub bar was drawn: back means again from the start. */
    chase() {
        if (this.progress() > this.target + .01 && this.run.world.steps) {
            const target = this.target;
            this.reset();
            this.target = target;
            return;
        }
        if (this.progress() >= this.target)
            this.target = null;
        else
            this.advance(this.scene.slow
                             ? 1000
                             : Math.ceil((this.target - this.progress()) * this.scene.seconds / this.run.world.dt));
    }

    draw(now) {
        const p = this.painter, scene = this.scene, r = scene.read(this.run, this.state),
              covered = !this.revealed.has(scene.id);
        r.tell = !covered;
        p.begin();
        scene.draw(p, this.run, this.state, r);
        for (const h of scene.handles?.(this.run, this.state) ?? [])
            p.c.globalAlpha = .35, p.circle(h.x, h.y, .35 * p.em / p.scale, {fill: p.ink}), p.c.globalAlpha = 1;
        if (now - this.told < 100) return;
        this.told = now;
        findTasks(this.run, this.state, r, this.hits.get(scene.id));
        r.tasks =
            (TASKS[scene.id] ??
             []).map((_, i) => `${this.hits.get(scene.id).has(i) ? '✓' : '○'} ${word(`scene.${scene.id}.tasks`)[i]}`);
        fillPanel(at('panel'), word(`scene.${scene.id}.title`), r, {covered, expert: this.expert});
        at('scrub').value = this.progress();
        if (!covered && now - (this.said ?? 0) > 1000 && this.live.textContent !== r.sentence)
            this.live.textContent = r.sentence ?? '', this.said = now;
    }

    /* ---- what stands around the picture ---- */

    building() {
        const s = this.scene;
        document.title = `${word(`scene.${s.id}.title`)} – ${word('ui.title')}`;
        at('scenes').replaceChildren(
            ...SCENES.map((x, i) => element('button',
                                            {'aria-current': x === s ? 'page' : false, onclick: () => this.choose(x)},
                                            `${i + 1} ${word(`scene.${x.id}.title`)}`)),
            element('span', {class: 'space'}),
            element('button', {'aria-pressed': String(this.expert), onclick: () => this.toggleExpert()},
                    word('ui.expert')),
            element('button', {onclick: () => this.share('link')}, word('ui.link')),
            element('button', {onclick: () => this.share('case')}, word('ui.case')),
            element('button', {onclick: () => this.share('still')}, word('ui.still')),
            element('button', {onclick: () => print()}, word('ui.print')),
            element('button', {onclick: () => this.help()}, '?'));
        at('controls')
            .replaceChildren(
                ...s.controls.map(c => this.control(c)),
                ...(s.actions ?? []).map(a => element('button', {onclick: () => a.run(this)}, word('ui.' + a.name))));
        this.question(), this.transport();
    }

    transport() {
        at('transport')
            .replaceChildren(element('button', {onclick: () => this.play(), 'aria-pressed': String(this.playing)},
                                     word(this.playing ? 'ui.pause' : 'ui.play')),
                             element('button', {onclick: () => this.step()}, word('ui.step')),
                             element('button', {onclick: () => this.slower()},
                                     word('ui.speed', {speed: ['1', '½', '⅕', '1⁄20'][this.speed]})),
                             element('button', {onclick: () => this.reset()}, word('ui.reset')), element('input', {
                                 type: 'range',
                                 id: 'scrub',
                                 min: 0,
                                 max: 1,
                                 step: .001,
                                 value: this.progress(),
                                 'aria-label': word('ui.scrub'),
                                 oninput: e => { this.playing = false, this.target = Number(e.target.value); }
                             }));
    }

    control(c) {
        const name = word(`control.${c.key}`) === `control.${c.key}` ? c.name : word(`control.${c.key}`),
              value = this.state[c.key];
        if (c.choices) {
            const select = element(
                'select', {id: `pick-${c.key}`, onchange: e => this.set(c, e.target.value)},
                ...c.choices.map(x => element('option', {value: x, selected: x === value},
                                              word(`choice.${x}`) === `choice.${x}` ? x : word(`choice.${x}`))));
            return element('label', {class: 'choice'}, name, select);
        }
        const range = {min: c.min, max: c.max, step: c.step, value};
        const slider = element(
            'input', {type: 'range', id: `slide-${c.key}`, ...range, oninput: e => this.set(c, e.target.value)});
        const number = element('input', {
            type: 'number',
            id: `type-${c.key}`,
            ...range,
            step: 'any',
            'aria-label': `${name} ${c.unit ?? ''}`,
            onchange: e => this.set(c, e.target.value)
        });
        return element('label', {}, name, slider, number, c.unit ?? '');
    }

    /* A value from a slider, a field or a hand. Outside of its range it stops at the limit, with a word. */
    set(c, text) {
        const {value, limited} = limit(c, text), moved = this.state[c.key] !== value;
        this.state[c.key] = value;
        for (const kind of ['slide', 'type', 'pick'])
            if (at(`${kind}-${c.key}`)) at(`${kind}-${c.key}`).value = value;
        if (limited && !c.choices)
            this.notice(word('ui.limit', {name: c.name, min: short(c.min), max: short(c.max), unit: c.unit ?? ''}));
        if (!moved) return;
        if (c.live && this.run?.world.steps)
            this.change();
        else if (!c.free)
            this.reset(this.playing);
        if (limited && !c.choices)
            this.notice(word('ui.limit', {name: c.name, min: short(c.min), max: short(c.max), unit: c.unit ?? ''}));
        this.address();
    }

    /* New laws while it runs; the case is then of a run from the start. */
    change() {
        try {
            this.run.world.setLaws(this.run.text = this.scene.text(this.state));
            this.run.beside?.setLaws(this.scene.other(this.state));
            this.run.changed = true;
        } catch (e) {
            this.failed(e);
        }
    }

    question() {
        const s = this.scene.id, answers = word(`scene.${s}.answers`), right = word(`scene.${s}.right`),
              open = this.revealed.has(s);
        const pick = i => {
            this.picked = i;
            this.revealed.add(s);
            this.question();
        };
        at('question')
            .replaceChildren(
                element('p', {}, word(`scene.${s}.question`)),
                element(
                    'div', {class: 'answers'},
                    ...answers.map((a, i) => element(
                                       'button',
                                       {'aria-pressed': open && i === right ? 'true' : 'false', onclick: () => pick(i)},
                                       `${i + 1} ${a}`))),
                element('p', {class: open ? '' : 'hint'}, open ? word(`scene.${s}.reveal`) : word('ui.predict')));
    }

    play() {
        if (!this.run) return;
        if (this.progress() >= 1) return this.reset(true);
        this.playing = !this.playing;
        this.transport();
    }

    step() {
        if (!this.run) return;
        this.playing = false;
        this.advance(this.scene.slow ? 100 : Math.ceil(.02 * this.scene.pace / this.run.world.dt));
        this.transport();
    }

    slower() {
        this.speed = (this.speed + 1) % SLOWER.length;
        this.transport();
    }

    toggleExpert() {
        this.expert = !this.expert;
        this.building();
    }

    address() {
        try {
            history.replaceState(null, '', toAddress(this.scene, this.state));
        } catch { /* some browsers forbid it from a file */
        }
    }

    /* ---- to take along ---- */

    share(what) {
        if (what === 'still')
            return this.painter.canvas.toBlob(
                blob => element('a', {href: URL.createObjectURL(blob), download: `${this.scene.id}.png`}).click());
        const texts = what === 'link' ? [location.href.replace(/#.*/, '') + toAddress(this.scene, this.state)]
                                      : [this.scene.text(this.state), this.scene.other?.(this.state)].filter(Boolean);
        const note = what === 'case' && this.run?.changed ? word('ui.changed') : '';
        navigator.clipboard?.writeText(texts[0]).catch(() => {});
        this.dialog(
            word(what === 'link' ? 'ui.link' : 'ui.caseHow'), note,
            ...texts.flatMap(
                (text, i) => [...(texts.length > 1 ? [element('p', {}, 'AB'[i])] : []),
                              element('textarea',
                                      {readonly: true, 'aria-label': texts.length > 1 ? `${what} ${'AB'[i]}` : what},
                                      text)]));
    }

    help() {
        this.dialog(word('ui.keys'), '',
                    element('table', {},
                            ...Object.entries(word('keys'))
                                .map(([k, v]) => element('tr', {}, element('td', {}, k), element('td', {}, v)))),
                    element('p', {}, `trundle ${this.engine.version()}`));
    }

    dialog(title, note, ...content) {
        const d = at('dialog');
        d.replaceChildren(element('h2', {}, title), element('p', {}, note), ...content,
                          element('p', {}, element('button', {onclick: () => d.close()}, word('ui.close'))));
        d.showModal();
    }

    keys() {
        const next = by => this.choose(SCENES[(SCENES.indexOf(this.scene) + by + SCENES.length) % SCENES.length]);
        const actions = {
            ' ': () => this.play(),
            '.': () => this.step(),
            ',': () => { this.target = Math.max(0, this.progress() - .02), this.playing = false; },
            s: () => this.slower(),
            0: () => this.reset(),
            e: () => this.toggleExpert(),
            '?': () => this.help(),
            r: () => (this.revealed.has(this.scene.id) ? this.revealed.delete(this.scene.id)
                                                       : this.revealed.add(this.scene.id),
                      this.question()),
            f: () =>
                document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen(),
            PageDown: () => next(1),
            PageUp: () => next(-1),
        };
        for (let i = 1; i <= 4; i++)
            actions[i] = () => at('question').querySelectorAll('.answers button')[i - 1]?.click();
        addEventListener('keydown', e => {
            const typing = e.target.matches?.('input[type=number], select, textarea'),
                  button = e.target.matches?.('button') && (e.key === ' ' || e.key === 'Enter');
            const action = actions[e.key] ?? actions[e.key.toLowerCase()];
            if (!action || typing || button || e.ctrlKey || e.altKey || e.metaKey || at('dialog').open) return;
            if (e.target.matches?.('input[type=range]') && e.key.startsWith('Page')) e.target.blur();
            e.preventDefault();
            action();
        });
    }

    pointer() {
        const canvas = at('picture');
        let held = null, from = null;
        canvas.addEventListener('pointerdown', e => {
            if (!this.run) return;
            const [x, y] = this.painter.world(e), reach = 1.2 * this.painter.em / this.painter.scale;
            const handles =
                (this.scene.handles?.(this.run, this.state) ?? []).map(h => ({h, far: Math.hypot(h.x - x, h.y - y)}));
            handles.sort((a, b) => a.far - b.far);
            held = handles[0]?.far < reach ? handles[0].h.key : null, from = [e.clientX, e.clientY];
            if (held) canvas.setPointerCapture(e.pointerId);
        });
        canvas.addEventListener('pointermove', e => {
            if (!held || !this.run) return;
            const h = this.scene.handles(this.run, this.state).find(k => k.key === held),
                  c = this.scene.controls.find(k => k.key === held);
            if (!h) return;
            const value = Math.round(h.value(...this.painter.world(e)) / c.step) * c.step;
            this.set(c, String(Number(Math.min(c.max, Math.max(c.min, value)).toFixed(6))));
        });
        canvas.addEventListener('pointerup', e => {
            if (!held && from && Math.hypot(e.clientX - from[0], e.clientY - from[1]) < 5 && this.run)
                this.scene.click?.(this.run, ...this.painter.world(e));
            held = from = null;
        });
    }
}

/* Two instructions of vectors: a browser without them cannot run the library. */
const SIMD = new Uint8Array(
    [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11]);

async function start() {
    if (!WebAssembly.validate(SIMD)) throw new Error(word('ui.noSimd'));
    const bytes = Uint8Array.from(atob(WASM), c => c.charCodeAt(0));
    window.app = new App(await loadEngine(bytes));
}

start().catch(e => { at('notice').hidden = false, at('notice').textContent = e.message; });
