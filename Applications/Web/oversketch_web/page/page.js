// The page: what the visitor's process says is shown, and what is done here is said to it.
import { Pad, away, inside } from "./pad.js";

const $ = id => document.getElementById(id);
const tools = {
  outline: { title: "Outline", key: "d", system: "OneStroke", path: "M7 22C7 13 9 11 12 11s5 2 5 11M2.500 17C2.500 7 6 2.500 12 2.500S21.500 7 21.500 17",
    advice: "Draw a line beside a limb's outline: the limb follows." },
  line: { title: "Line", key: "b", system: "Augment", path: "M1.500 18C7 18 9.500 16 12 6c2.500 10 5 12 10.500 12M12 2v.5M1.500 21.500h21",
    advice: "Draw a line on the model: it rises there. Its form has width, height and profile." },
  smooth: { title: "Smooth", key: "q", system: "Relax", path: "M1.500 9C3 4 5 4 6.500 9s3 4 4.500-1 3.500-5 5 0 4 4 6.500-1M1.500 19C8 16 15 16 22.500 19",
    advice: "Draw over what is rough: it is smooth there." },
  mask: { title: "Mask", key: "4", system: "Mask", path: "M4 9.500a8 6.500 0 1 0 16 0a8 6.500 0 1 0-16 0M8 12.500l5.500-7M12 13l4-5M10 16c-2 3 2 4-1 6.500",
    advice: "Draw a lasso round what is to stay: it is dark, and no step moves it." },
  pose: { title: "Pose", key: "6", system: "Pose", path: "M7 18.500a2.500 2.500 0 1 1-5 0a2.500 2.500 0 1 1 5 0h15M6 16.500L15 4m.5 4.500L15 4l-4.200 1.600",
    advice: "Draw a bone along a limb, from the joint that stays to the tip; then from the joint on where it is to go." },
  edit: { title: "Edit", key: "e", system: "Edit", path: "M2 20c4-7 7-3 9-5V3M8.500 6L11 3l2.500 3M11 15h11m-3-2.500l3 2.500-3 2.500M11 15l5 6.500",
    advice: "Draw a line on the model, then a ring round it: what lies between follows the line." },
  drawing: { title: "Drawing", key: "g", system: "OneStroke", path: "M2 3h20v18H2zM7 15c-3-5 1-9 5-7c4-3 9 1 5.500 5C16 18 9 19 7 15",
    advice: "Draw round the shape, ending where you began, or tap on it: it becomes a model. A tap in a closed line: hole, tunnel, filled." },
};
const kept = { Augment: null, Relax: null, Mask: ["Mode", "Through"] }; // values that the next line has, too; null: all
const colours = { Bone: "#2f6fbe", Boundary: "#2f6fbe" };
const reach = { mouse: 9, pen: 12, touch: 22 }; // px to a line that is taken hold of
const blank = "data:image/gif;base64,R0lGODlhAQABAIAAAP///wAAACH5BAAAAAAALAAAAAABAAEAAAICRAEAOw==";

let socket, state = { steps: [] }, systems = {}, tool = "outline", redraws = 0, sent = 0, lost = 0;
let held = {}, waiting = [], moved = null; // lines on the model; those that are drawn and not yet done; a drag [px]
let shown = null; // promise that all pictures which have come are drawn
let cut = {}, listed = "", formed = "", next = null, later = null;
const values = {};

const say = (work, more = {}) => socket?.readyState === 1 && socket.send(JSON.stringify({ do: work, ...more }));
const act = (what, ...given) => say("act", { what, arguments: given });
const scaled = length => length * window.devicePixelRatio;
const chosen = () => state.steps.find(step => step.id === state.selected);

// The model.

const model = new Pad($("pen"), {
  fitted(width, height) {
    say("size", { width, height });
  },
  grabs(x, y, event) {
    const lines = tool === "edit" && !redraws && !state.waits && chosen()?.system === "Edit" ? held.Reference ?? [] : [];
    return lines.some(line => away(line, x, y) < reach[event.pointerType]);
  },
  dragged(from, to, ends) {
    moved = [to[0] - from[0], to[1] - from[1]];
    if (ends && Math.hypot(...moved) < 2) moved = null;
    else if (ends) say("drag", { number: wait(null), start: from.map(scaled), end: to.map(scaled) });
    model.paint();
  },
  line(points, event) {
    const system = event.shiftKey && !redraws ? "Relax" : tools[tool].system, mirror = $("mirror").value;
    say("stroke", { number: wait(points), system, redraw: redraws, values: values[system] ?? {}, mirror: mirror && +mirror,
      points: points.map(([x, y, p]) => [scaled(x), scaled(y), p]) });
  },
  hand(name, x, y, event = {}) { // one move a frame
    const flush = () => {
      cancelAnimationFrame(later);
      if (next) say("hand", next);
      next = later = null;
    };
    if (name !== "MouseMoveEvent") flush();
    next = { event: name, x: scaled(x), y: scaled(y), keys: ["ctrl", "shift", "alt"].filter(key => event[`${key}Key`]) };
    name === "MouseMoveEvent" ? later ??= requestAnimationFrame(flush) : flush();
  },
  zoom(factor, x, y) {
    say("zoom", { factor, x: scaled(x), y: scaled(y) });
  },
  under(pad) {
    for (const [name, lines] of Object.entries(held)) {
      const by = moved && name === "Reference" ? moved : [0, 0];
      for (const line of lines) pad.line(line.map(([x, y]) => [x + by[0], y + by[1], 0.5]), 0, colours[name]);
    }
    for (const one of waiting) if (one.points) pad.line(one.points);
  },
});

// A line that the server has not done yet; returns its number.
function wait(points) {
  waiting.push({ points, number: ++sent, when: performance.now() });
  return sent;
}

async function frame(bytes) {
  const length = new DataView(bytes).getUint32(0), meta = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  const image = await createImageBitmap(new Blob([new Uint8Array(bytes, 4 + length)])), canvas = $("picture");
  [canvas.width, canvas.height] = [image.width, image.height];
  canvas.getContext("2d").drawImage(image, 0, 0);
  say("got", { frame: meta.frame });
  if (meta.model) lost = 0;
  held = meta.held;
  for (const lines of Object.values(held)) for (const line of lines) for (const place of line) place.forEach((length, k) => place[k] = length / scaled(1));
  const done = waiting.filter(one => one.number <= meta.done);
  for (const one of done) performance.measure("stroke", { start: one.when });
  if (done.length && model.does !== "drag") moved = null;
  waiting = waiting.filter(one => one.number > meta.done);
  model.paint();
  Object.assign($("view").dataset, { frame: meta.frame, done: meta.done, model: meta.model });
}

// The drawing, in shares of what is drawn on, and the section of an edit, in its own plane: from ring to ring, outward up.

const drawing = new Pad($("lines"), {
  line(points) {
    const box = paper();
    say("trace", { number: wait(null), points: points.map(([x, y, p]) => [(x - box.left) / box.width, (y - box.top) / box.height, p]) });
  },
  tap(x, y) {
    const box = paper(), place = [(x - box.left) / box.width, (y - box.top) / box.height], step = state.steps.find(one => one.id === state.drawing.id);
    const line = state.drawing.lines.findLastIndex((line, k) => k > 0 && inside(line, ...place)); // of an object, not its outline
    if (line < 0) return state.drawing.picture && say("trace", { number: wait(null), points: [place] });
    const numbers = name => new Set((step.values[name] ?? "").split(" ").filter(Boolean).map(Number)), holes = numbers("Holes"), tunnels = numbers("Tunnels");
    if (holes.delete(line)) tunnels.add(line);
    else if (!tunnels.delete(line)) holes.add(line);
    say("change", { id: step.id, values: { Holes: [...holes].join(" "), Tunnels: [...tunnels].join(" ") } });
  },
  under(pad) {
    const box = paper();
    Object.assign($("under").style, Object.fromEntries(["left", "top", "width", "height"].map(side => [side, `${box[side]}px`])));
    for (const line of state.drawing?.lines ?? []) {
      pad.line(line.map(([x, y]) => [box.left + x * box.width, box.top + y * box.height, 0.4]), 0, colours.Bone);
    }
  },
});

function paper() {
  const across = $("lines").clientWidth - 16, up = $("lines").clientHeight - 16, image = $("under"), [, , wide, high] = state.drawing?.canvas ?? [0, 0, 4, 3];
  const [w, h] = state.drawing?.picture && image.naturalWidth ? [image.naturalWidth, image.naturalHeight] : [wide, high];
  const scale = Math.min(across / w, up / h), [width, height] = [w * scale, h * scale];
  return { width, height, left: 8 + (across - width) / 2, top: 8 + (up - height) / 2 };
}

$("under").addEventListener("load", () => {
  if (state.drawing?.picture) say("paper", { width: $("under").naturalWidth, height: $("under").naturalHeight });
  drawing.paint();
});

const plane = () => {
  const wide = $("section").clientWidth, high = $("section").clientHeight;
  return { left: 0.15 * wide, base: 0.8 * high, width: 0.7 * wide };
};
const section = new Pad($("section"), {
  line(points) {
    const { left, base, width } = plane();
    say("section", { number: wait(null), points: points.map(([x, y]) => [(x - left) / width, (base - y) / width]) });
  },
  under(pad) {
    const { left, base, width } = plane();
    for (const line of cut.lines ?? [[[0, 0], [1, 0]]]) pad.line(line.map(([x, y]) => [left + x * width, base - y * width, 0.3]), 0, "#5d646d");
  },
});

// What is beside the model.

function take(name) {
  [tool, redraws] = [name, 0];
  for (const button of $("tools").children) button.setAttribute("aria-pressed", button.dataset.tool === name);
  show();
}

function show() {
  const step = chosen(), picture = state.drawing?.picture ?? "";
  $("undo").disabled = !state.undo;
  $("redo").disabled = !state.redo;
  $("progress").hidden = $("cancel").hidden = !state.busy;
  $("pad").hidden = tool !== "drawing" || !state.drawing;
  if ($("under").dataset.of !== picture) [$("under").src, $("under").dataset.of] = [picture ? `files/${picture}` : blank, picture];
  drawing.paint();
  $("profile").hidden = step?.system !== "Edit" || !!state.waits;
  if (!$("profile").hidden && cut.id !== step.id) say("profile", { id: (cut = { id: step.id }).id });
  section.paint();
  const shown = tool === "drawing" ? state.steps.find(one => one.id === state.drawing?.id) : step;
  const wrong = state.message || !state.busy && shown?.failure;
  $("advice").textContent = titled(wrong) || (state.busy && state.stage ? `${state.stage} …` : advice(step));
  $("advice").classList.toggle("said", !!wrong);
  list();
  form(step);
}

// A message with the titles of settings, which it calls by their properties.
function titled(text) {
  const all = Object.values(systems).flatMap(system => system.parameters);
  return text && text.replace(/\b[A-Z]\w+[A-Z]\w*\b/g, word => all.find(one => one.property === word)?.title ?? word);
}

function advice(step) {
  if (redraws) return `Draw “${state.steps.find(one => one.id === redraws)?.name}” anew${state.waits ? ": its next line" : ""}. Escape leaves it.`;
  if (state.waits === "Edit") return "Now draw a ring round the line; it closes by itself. Escape takes the line back.";
  if (tool === "edit" && step?.system === "Edit") return "Drag the red line, or draw its section anew in the history. Escape: done.";
  if (tool === "pose" && step?.system === "Pose") return "Draw from the joint on where the bone is to go. Escape: done.";
  return tool === "drawing" && !state.drawing ? "Open a picture to draw over, or Draw new for an empty canvas." : tools[tool].advice;
}

const element = (name, properties, ...inner) => {
  const one = Object.assign(document.createElement(name), properties);
  one.append(...inner);
  return one;
};
const button = (text, onclick, title = "", more = {}) => element("button", { type: "button", onclick, title, ...more }, text);

function list() {
  const now = JSON.stringify([state.steps, state.selected]);
  if (now === listed) return;
  listed = now;
  $("steps").replaceChildren(...state.steps.map(step => {
    const { id, name, on } = step, is = id === state.selected, note = [step.failure, ...step.remarks].filter(Boolean).join(" ");
    const box = element("input", { type: "checkbox", checked: on, title: "A step that is off does nothing", ariaLabel: `${name} acts`,
      onchange: () => act("SetStepOn", id, box.checked) });
    const acts = element("div", { className: "acts", hidden: !is },
      button("Redraw", () => {
        redraws = id;
        document.querySelector("aside").classList.remove("open");
        show();
      }, "The next line takes its place"),
      button("View", () => say("sight", { id }), "From where it was drawn"),
      button("Delete", () => act("RemoveStep", id)));
    return element("li", { ariaCurrent: is }, element("label", { className: "tick" }, box),
      button(name, () => say("select", { id: is ? 0 : id })), acts, element("small", { hidden: !note }, titled(note)));
  }));
}

function form(step) {
  const now = JSON.stringify([step?.id, step?.values]);
  if (now === formed || $("form").contains(document.activeElement)) return;
  formed = now;
  $("form").replaceChildren(...(step ? systems[step.system].parameters : []).map(one => {
    const { property, kind } = one, value = step.values[property] ?? one.default, number = kind === "int" || kind === "double";
    const field = element(kind === "choice" ? "select" : "input", { name: property },
      ...(kind === "choice" ? one.choices.map(choice => new Option(choice.title, choice.word)) : []));
    if (kind === "bool") [field.type, field.checked] = ["checkbox", value];
    else if (number && one.least < one.most) {
      Object.assign(field, { type: "range", min: one.least, max: one.most, step: kind === "int" ? 1 : (one.most - one.least) / 100 });
    } else if (number) [field.type, field.step] = ["number", "any"];
    if (kind !== "bool") field.value = kind === "numbers" ? value.join(" ") : value;
    field.onchange = () => {
      const given = kind === "bool" ? field.checked : number ? +field.value : kind === "numbers" ? field.value.split(/[ ,]+/).map(Number) : field.value;
      if (kept[step.system]?.includes(property) ?? step.system in kept) (values[step.system] ??= {})[property] = given;
      say("change", { id: step.id, values: { [property]: given } });
      field.blur();
    };
    return element("label", { title: one.help }, one.title, field);
  }));
}

// Files.

function send(file) {
  state.message = "";
  const asked = new XMLHttpRequest();
  asked.open("POST", `upload?name=${encodeURIComponent(file.name)}`);
  asked.upload.onprogress = ({ loaded, total }) => veil(`Sending ${file.name}: ${Math.round(100 * loaded / total)} %`);
  asked.onloadend = () => {
    veil("");
    if (asked.status === 200) return begin("open", { file: JSON.parse(asked.responseText).file, name: file.name });
    state.message = asked.responseText || "The file could not be sent.";
    show();
  };
  asked.send(file);
}

function begin(work, more) {
  [held, waiting, moved, redraws, cut] = [{}, [], null, 0, {}];
  say(work, more);
}

function veil(text, ...more) {
  $("veil").hidden = !text;
  $("veil").replaceChildren(text, ...more);
}

$("file").onchange = () => {
  if ($("file").files[0]) send($("file").files[0]);
  $("file").value = "";
};
document.ondragover = event => event.preventDefault();
document.ondrop = event => {
  event.preventDefault();
  if (event.dataTransfer.files[0]) send(event.dataTransfer.files[0]);
};
$("own").onclick = () => {
  $("files").close();
  $("file").click();
};
$("open").onclick = () => $("offered").children.length > 1 ? $("files").showModal() : $("file").click();
$("canvas").onclick = () => begin("canvas", { width: 1024, height: 768 });
for (const id of ["save", "cancel"]) $(id).onclick = () => say(id);
[$("undo").onclick, $("redo").onclick] = [() => act("Undo"), () => act("Redo")];
$("history").onclick = () => ($("history").ariaExpanded = document.querySelector("aside").classList.toggle("open"));
for (const [id, name] of [["export", "format"], ["look", "side"]]) {
  $(id).onchange = () => {
    say(id, { [name]: $(id).value });
    $(id).value = "";
  };
}
$("form").onsubmit = event => event.preventDefault();
for (const [name, { title, key, path, advice }] of Object.entries(tools)) {
  const one = button("", () => {
    take(name);
    say("drop");
  }, `${advice} (${key.toUpperCase()})`);
  one.innerHTML = `<svg viewBox="0 0 24 24" aria-hidden="true"><path d="${path}"/></svg>${title}`;
  one.dataset.tool = name;
  $("tools").append(one);
}

document.onkeydown = event => {
  const key = event.key.toLowerCase(), control = event.ctrlKey || event.metaKey;
  if (event.target.closest("input, select, dialog") || event.altKey) return;
  const pressed = control ? $({ z: event.shiftKey ? "redo" : "undo", y: "redo", s: "save", o: "open" }[key])
    : event.shiftKey ? null : [...$("tools").children].find(one => tools[one.dataset.tool].key === key);
  if (pressed) pressed.click();
  else if (control) return;
  else if (key === "escape" || key === "enter") [redraws] = [0, say("drop")];
  else if (key === "delete") act("RemoveStep", state.selected);
  else if (key === "5" || key === "home") say("look", { side: key === "5" ? "projection" : "all" });
  else if (key.length === 1 && "xyz123imjkrlhpnwc".includes(key)) say("key", { name: key, shift: event.shiftKey });
  else return;
  event.preventDefault();
};

// The server.

function connect() {
  socket = new WebSocket(new URL("socket", location.href.replace(/^http/, "ws")));
  socket.binaryType = "arraybuffer";
  shown = Promise.resolve();
  socket.onopen = () => {
    waiting = [];
    veil("");
    model.fit();
  };
  socket.onmessage = ({ data }) => {
    const heard = typeof data === "string" ? JSON.parse(data) : { kind: "frame" };
    if (heard.kind === "frame") shown = shown.then(() => frame(data));
    else if (heard.kind === "systems") {
      systems = Object.fromEntries(heard.systems.map(system => [system.name, system]));
      $("export").replaceChildren($("export").options[0], ...heard.formats.map(format => new Option(format)));
      $("offered").replaceChildren(...heard.files.map(shared => element("li", {}, button(shared, () => {
        $("files").close();
        begin("open", { shared });
      }))));
    } else if (heard.kind === "file") element("a", { href: `files/${heard.file}`, download: heard.name }).click();
    else if (heard.kind === "section") {
      cut = heard;
      section.paint();
    } else {
      const begins = heard.drawing && heard.drawing.id !== state.drawing?.id && heard.steps.length === 1;
      if (heard.busy && !heard.waits) redraws = 0;
      state = heard;
      document.title = `${state.name} – Oversketch`;
      begins ? take("drawing") : show();
    }
  };
  socket.onclose = async ({ code }) => {
    waiting = [];
    if (code === 4002) return veil("As many visitors as this server takes are drawing. ", button("Try again", connect));
    if (code === 4003) return veil("The page is open in another tab. ", button("Go on here", connect));
    const answer = await fetch(location.href).catch(() => null);
    if (answer?.status === 404) return veil(await answer.text());
    veil(code === 4001 ? "That was too much for the server. It goes on from the last step …" : "The server does not answer. Trying again …");
    setTimeout(connect, Math.min(5000, 300 * 2 ** lost++));
  };
}

take("outline");
connect();
