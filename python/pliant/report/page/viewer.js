// SPDX-License-Identifier: MIT
// The 3-D view of the page: decodes the scene, draws a frame with 3Dmol.js, plays the run.
"use strict";
function startViewer() {
  const scene = JSON.parse(document.getElementById("scene").textContent);
  const page = document.documentElement;
  const colour = (name) => getComputedStyle(page).getPropertyValue(name).trim();
  const count = scene.frames.length;
  const atomCount = scene.atoms.names.length;
  const barCount = scene.bars.length / 2;

  // The usual colours of the elements, softened; blue to orange, which all eyes tell apart.
  const elementColours = {
    H: "#f1f3f5", C: "#6f7983", N: "#3d6fd6", O: "#e2483d", S: "#e9bd2c", P: "#e88a2c",
    F: "#63b96a", Cl: "#3fa34d", Br: "#a0522d", I: "#7b4fa3", Se: "#d9992b",
  };
  const ramp = [[47, 103, 153], [127, 165, 196], [222, 226, 228], [238, 180, 110], [213, 94, 0]];
  const six = ["#0072b2", "#e69f00", "#009e73", "#cc79a7", "#56b4e9", "#d55e00"];
  const domainColours = [...six, ...six, ...six, ...six]; // there can be twenty domains
  // Of what has kinds, not amounts: a colour a kind, and grey for the rest.
  const palettes = { domain: domainColours, ...scene.palettes };
  const loose = "#c3cad1";
  const resting = [213, 219, 225], strained = [0, 114, 178], broken = "#d55e00";

  const bytes = (text) => Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const positions = new Int16Array(bytes(scene.positions).buffer);
  const residuals = bytes(scene.residuals);

  const hex = (rgb) => "#" + rgb.map((v) => Math.round(v).toString(16).padStart(2, "0")).join("");
  const mix = (a, b, t) => a.map((v, k) => v + (b[k] - v) * t);
  function rampAt(t) {
    const place = Math.min(1, Math.max(0, t)) * (ramp.length - 1);
    const k = Math.min(ramp.length - 2, Math.floor(place));
    return hex(mix(ramp[k], ramp[k + 1], place - k));
  }

  // A residual's code is 0 to 255 on a logarithmic scale; at the tolerance the logarithm is 0.
  const barColours = Array.from({ length: 256 }, (_, code) => {
    const decades = code / scene.residual_codes.per_decade + scene.residual_codes.lowest;
    return decades > 0 ? broken : hex(mix(resting, strained, Math.max(0, 1 + decades / 3)));
  });

  function atomColours(kind) {
    const { elements, unit } = scene.atoms;
    const values = scene.units[kind];
    if (palettes[kind] && values) return unit.map((k) => palettes[kind][values[k]] || loose);
    if (values) {
      const top = scene.tops?.[kind] || values.slice().sort((a, b) => a - b)[Math.floor(0.98 * (values.length - 1))] || 1;
      return unit.map((k) => (k < 0 ? loose : rampAt(values[k] / top)));
    }
    if (kind === "residual") return elements.map(() => hex(resting));
    return elements.map((element) => elementColours[element] || "#8a929b");
  }

  function makeAtoms(pairs) {
    const { names, elements, residues, numbers, chains, cartoon } = scene.atoms;
    const atoms = names.map((name, k) => ({
      serial: k, index: k, atom: name, elem: elements[k], resn: residues[k], resi: numbers[k],
      chain: chains[k], hetflag: cartoon[k] === "l", ss: cartoon[k] || "c", bonds: [], bondOrder: [],
      x: 0, y: 0, z: 0,
    }));
    for (let k = 0; k < pairs.length; k += 2) {
      const a = pairs[k], b = pairs[k + 1];
      atoms[a].bonds.push(b);
      atoms[a].bondOrder.push(1);
      atoms[b].bonds.push(a);
      atoms[b].bondOrder.push(1);
    }
    return atoms;
  }

  const viewer = $3Dmol.createViewer(document.getElementById("view"), {
    backgroundColor: colour("--view"), antialias: true, cartoonQuality: atomCount > 4000 ? 4 : 7,
    disableFog: atomCount < 200,
  });
  const bonded = viewer.addModel();
  bonded.addAtoms(makeAtoms(scene.bonds));
  const framework = viewer.addModel();
  framework.addAtoms(makeAtoms(scene.bars));
  const bondedAtoms = bonded.selectedAtoms({});
  const frameworkAtoms = framework.selectedAtoms({});
  const barStyles = styleOfEachBar();

  // Each bar's style, as 3Dmol wants it at both of its ends.
  function styleOfEachBar() {
    const styles = Array.from({ length: barCount }, () => ({ color1: broken, color2: broken }));
    frameworkAtoms.forEach((atom) => { atom.bondStyles = []; });
    styles.forEach((style, k) => {
      for (const [from, to] of [[0, 1], [1, 0]]) {
        const atom = frameworkAtoms[scene.bars[2 * k + from]];
        atom.bondStyles[atom.bonds.indexOf(scene.bars[2 * k + to])] = style;
      }
    });
    return styles;
  }

  const state = { frame: 0, style: "", colour: "", series: "", playing: false };
  const large = atomCount > 400;
  let colours = [];

  function styleOf(kind) {
    const colour = { colorfunc: (atom) => colours[atom.serial] };
    const lone = scene.bonds.length === 0 || scene.trace_only;
    return {
      "Ball and stick": { stick: { radius: 0.13, ...colour }, sphere: { scale: 0.25, ...colour } },
      Sticks: { stick: { radius: large ? 0.15 : 0.2, ...colour }, ...(lone ? { sphere: { radius: 0.8, ...colour } } : {}) },
      Spheres: { sphere: { scale: scene.trace_only ? 0.6 : 1, ...colour } },
      Lines: { line: { linewidth: 2, ...colour } },
      Cartoon: { cartoon: { arrows: true, ...colour } },
    }[kind];
  }

  function place(atoms, frame) {
    const start = frame * atomCount * 3;
    for (let k = 0; k < atomCount; k++) {
      atoms[k].x = positions[start + 3 * k] * scene.step;
      atoms[k].y = positions[start + 3 * k + 1] * scene.step;
      atoms[k].z = positions[start + 3 * k + 2] * scene.step;
    }
  }

  function draw() {
    const bars = state.colour === "residual";
    const [shown, hidden] = bars ? [framework, bonded] : [bonded, framework];
    place(bars ? frameworkAtoms : bondedAtoms, state.frame);
    if (bars) {
      const start = state.frame * barCount;
      barStyles.forEach((style, k) => { style.color1 = style.color2 = barColours[residuals[start + k]]; });
    }
    hidden.setStyle({}, {});
    const radius = large ? 0.16 : 0.12;
    const ball = { colorfunc: (atom) => colours[atom.serial], radius: large ? 0.16 : 0.26 };
    shown.setStyle({}, bars ? { stick: { radius, color: hex(resting) }, sphere: ball } : styleOf(state.style));
    if (!bars && state.style === "Cartoon") shown.setStyle({ hetflag: true }, styleOf("Ball and stick"));
    viewer.render();
    page.dataset.frame = String(state.frame);
  }

  function show(frame) {
    state.frame = Math.max(0, Math.min(count - 1, frame));
    draw();
    document.getElementById("slider").value = String(state.frame);
    const { label, values } = scene.axis;
    const where = label === "frame" ? "" : ` · ${label.split(" (")[0]} ${Number(values[state.frame].toPrecision(6))}${label.includes("ps") ? " ps" : ""}`;
    document.getElementById("place").textContent = `frame ${scene.frames[state.frame]}${where}`;
    window.pliantTimeline.draw(state);
  }

  function legend() {
    const box = document.getElementById("legend");
    const [left, strip, right] = box.children;
    box.hidden = state.colour === "element";
    box.style.display = box.hidden ? "none" : "flex"; // the class's display overrides `hidden`
    const palette = palettes[state.colour];
    if (palette) {
      const kinds = [...new Set(scene.units[state.colour])].filter((k) => palette[k]).sort((a, b) => a - b);
      const told = scene.legends?.[state.colour] ?? `${kinds.length} domains; grey: none`;
      [left.textContent, right.textContent] = ["", told];
      const step = 100 / kinds.length;
      strip.style.background = kinds.length ? `linear-gradient(90deg, ${kinds.map((k, place) =>
        `${palette[k]} ${place * step}% ${(place + 1) * step}%`).join(",")})` : loose;
    } else if (["mobility", "motion", "flexibility"].includes(state.colour)) {
      [left.textContent, right.textContent] = {
        mobility: ["still", "mobile (RMSF)"], motion: ["still", "moved by PC1"],
        flexibility: ["rigid (0)", `flexible (${scene.tops?.flexibility})`],
      }[state.colour];
      strip.style.background = `linear-gradient(90deg, ${ramp.map(hex).join(",")})`;
    } else if (state.colour === "residual") {
      [left.textContent, right.textContent] = ["bar at rest", "at tolerance, beyond"];
      strip.style.background = `linear-gradient(90deg, ${hex(resting)}, ${hex(strained)} 78%, ${broken} 78%)`;
    }
  }

  // A row of buttons of which one is pressed.
  function choices(id, entries, chosen, choose) {
    const group = document.querySelector(`#${id} .choice`);
    const press = (key) => {
      for (const button of group.children) button.setAttribute("aria-pressed", String(button.dataset.key === key));
      choose(key);
    };
    for (const [key, label] of entries) {
      const button = document.createElement("button");
      button.type = "button";
      button.dataset.key = key;
      button.textContent = label;
      button.addEventListener("click", () => press(key));
      group.append(button);
    }
    document.getElementById(id).hidden = entries.length < 2;
    if (entries.length) press(chosen);
  }

  function controls() {
    const protein = scene.atoms.cartoon !== "";
    const styles = (protein ? ["Cartoon"] : []).concat(["Ball and stick", "Sticks", "Spheres", "Lines"]);
    choices("styles", styles.map((name) => [name, name]), styles[0], (key) => {
      state.style = key;
      if (state.ready) draw();
    });
    const kinds = [["element", "element"]];
    const labels = {
      cluster: "rigid clusters", flexibility: "flexibility", mobility: "mobility", domain: "domains", motion: "PC1",
    };
    for (const key of Object.keys(labels)) if (scene.units[key]) kinds.push([key, labels[key]]);
    if (barCount) kinds.push(["residual", "bar residual"]);
    choices("colours", kinds, scene.units.cluster ? "cluster" : protein && scene.units.mobility ? "mobility" : "element", (key) => {
      state.colour = key;
      colours = atomColours(key);
      legend();
      if (state.ready) draw();
    });
    choices("series", Object.entries(scene.series).map(([key, one]) => [key, one.label]),
      Object.keys(scene.series)[0], (key) => {
        state.series = key;
        window.pliantTimeline.draw(state);
      });
  }

  const icons = { play: "M3 1.5v13l11-6.5z", pause: "M3 1.5h3.6v13H3zM9.4 1.5H13v13H9.4z" };

  function setPlaying(playing) {
    state.playing = playing && count > 1;
    const button = document.getElementById("play");
    button.setAttribute("aria-label", state.playing ? "pause" : "play");
    button.querySelector("path").setAttribute("d", state.playing ? icons.pause : icons.play);
    page.dataset.playing = String(state.playing);
    if (state.playing) requestAnimationFrame(tick);
  }

  // About 12 frames a second at 1×; a slow browser skips frames rather than falls behind.
  let due = 0;
  function tick(now) {
    if (!state.playing) return;
    const pause = 1000 / (12 * Number(document.getElementById("speed").value));
    if (now >= due) {
      const behind = due ? Math.min(8, Math.floor((now - due) / pause)) : 0;
      due = now + pause;
      show((state.frame + 1 + behind) % count);
    }
    requestAnimationFrame(tick);
  }

  function listen() {
    if (count < 2) for (const one of document.querySelectorAll(".timeline, .bar.play")) one.style.display = "none";
    const slider = document.getElementById("slider");
    slider.max = String(count - 1);
    slider.addEventListener("input", () => show(Number(slider.value)));
    document.getElementById("play").addEventListener("click", () => setPlaying(!state.playing));
    document.getElementById("reset").addEventListener("click", () => { home(); draw(); });
    document.addEventListener("keydown", (event) => {
      if (/^(INPUT|SELECT|BUTTON|SUMMARY)$/.test(event.target.tagName)) return;
      const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
      if (event.key === " ") setPlaying(!state.playing);
      else if (step) show(state.frame + step);
      else return;
      event.preventDefault();
    });
    window.pliantTimeline.onSeek((frame) => { setPlaying(false); show(frame); });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
      viewer.setBackgroundColor(colour("--view"));
      window.pliantTimeline.draw(state);
    });
    window.addEventListener("resize", () => { viewer.resize(); window.pliantTimeline.draw(state); });
  }

  // The scene lies so that the molecule is thinnest along the line of sight.
  function home() {
    place(bondedAtoms, state.frame);
    place(frameworkAtoms, state.frame);
    viewer.setView([0, 0, 0, 0, 0, 0, 0, 1]);
    viewer.zoomTo({}, 0);
    viewer.zoom(1.08);
  }

  window.pliantTimeline.start(scene);
  controls();
  listen();
  state.ready = true;
  home();
  show(0);
  document.getElementById("message").hidden = true;
  page.dataset.viewer = "drawn";
}

try {
  startViewer();
} catch (error) {
  document.documentElement.dataset.viewer = "failed";
  document.getElementById("message").hidden = false;
  document.getElementById("message").textContent =
    `The 3-D view could not be drawn: ${error && error.message ? error.message : error}. ` +
    "It needs a browser with WebGL. The rest of the page is whole.";
}
