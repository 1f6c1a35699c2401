// A canvas on which a pen, a finger or a mouse draws lines: each is on the screen as soon as its samples come. One finger draws
// once it moves, two turn what is seen or zoom, as in the window.

const still = 8; // px: less is no movement of a finger
const ofPressure = 4; // px of a line that is pressed hard

export class Pad {
  // acts: line(points, event); tap(x, y); grabs(x, y, event), whether something is taken hold of there, and dragged(from, to, ends);
  // under(pad), draws what lies there; hand(name, x, y, event) and zoom(factor, x, y), where the view can be turned; fitted.
  constructor(canvas, acts) {
    this.canvas = canvas;
    this.acts = acts;
    this.context = canvas.getContext("2d", { desynchronized: true });
    this.fingers = new Map();
    this.points = null; // of the line that is drawn: x, y, pressure
    this.does = ""; // "line", "drag", "hand", "wait", "two", "turn", "pinch"
    const on = (name, work) => canvas.addEventListener(name, work, { passive: false });
    on("pointerdown", event => this.down(event));
    on("pointermove", event => this.moves(event));
    on("pointerup", event => this.up(event));
    on("pointercancel", event => this.cancel(event));
    on("contextmenu", event => event.preventDefault());
    on("wheel", event => {
      event.preventDefault();
      const notches = -event.deltaY / (event.deltaMode ? 3 : 100);
      acts.zoom?.(Math.exp(notches * (event.ctrlKey ? 0.5 : 0.1)), ...this.at(event));
    });
    new ResizeObserver(() => this.fit()).observe(canvas);
  }

  fit() {
    const ratio = window.devicePixelRatio;
    this.canvas.width = Math.round(this.canvas.clientWidth * ratio);
    this.canvas.height = Math.round(this.canvas.clientHeight * ratio);
    this.acts.fitted?.(this.canvas.width, this.canvas.height);
    this.paint();
  }

  at(event) {
    const box = this.canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  }

  down(event) {
    event.preventDefault();
    document.activeElement?.blur();
    this.canvas.setPointerCapture(event.pointerId);
    const [x, y] = this.at(event);
    if (event.pointerType === "touch") {
      this.fingers.set(event.pointerId, [x, y]);
      if (this.fingers.size === 1 && !this.does) {
        this.does = "wait";
        this.from = [x, y];
      } else if (this.fingers.size === 2 && ["wait", "line", "drag"].includes(this.does)) {
        this.giveUp();
        this.does = this.acts.hand ? "two" : "";
        [this.from, this.apart] = this.twoFingers();
      }
      return;
    }
    if (this.does) return;
    const plain = event.button === 0 && !event.altKey && !event.ctrlKey && !event.metaKey;
    plain ? this.begin(x, y, event) : this.turn(event, "Press");
  }

  begin(x, y, event) {
    this.from = [x, y];
    this.does = this.acts.grabs?.(x, y, event) ? "drag" : "line";
    this.points = this.does === "drag" ? null : [[x, y, pressure(event)]];
  }

  turn(event, what) {
    if (!this.acts.hand) return;
    this.does = what === "Press" ? "hand" : "";
    this.button = what === "Press" ? ["Left", "Middle", "Right"][event.button] ?? "Middle" : this.button;
    if (what === "Press") this.acts.hand("MouseMoveEvent", ...this.at(event), event);
    this.acts.hand(`${this.button}Button${what}Event`, ...this.at(event), event);
  }

  moves(event) {
    const [x, y] = this.at(event);
    if (event.pointerType === "touch") {
      if (!this.fingers.has(event.pointerId)) return;
      this.fingers.set(event.pointerId, [x, y]);
      if (this.fingers.size === 2) return this.pair();
      if (this.does === "wait" && Math.hypot(x - this.from[0], y - this.from[1]) > still) this.begin(...this.from, event);
    }
    if (this.does === "line") this.draw(event);
    else if (this.does === "drag") this.acts.dragged(this.from, [x, y], false);
    else if (this.does === "hand") this.acts.hand("MouseMoveEvent", x, y, event);
  }

  // All samples since the last event, at once on the canvas.
  draw(event) {
    const given = event.getCoalescedEvents?.() ?? [];
    const samples = given.length ? given : [event];
    for (const sample of samples) {
      const [x, y] = this.at(sample), last = this.points[this.points.length - 1];
      if (x !== last[0] || y !== last[1]) this.points.push([x, y, pressure(sample)]);
    }
    this.line(this.points, Math.max(0, this.points.length - samples.length - 1));
    requestAnimationFrame(now => performance.measure("pen", { start: event.timeStamp, end: Math.max(now, event.timeStamp) }));
  }

  line(points, first = 0, colour = "#d62a20") {
    const context = this.context, ratio = window.devicePixelRatio;
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    [context.strokeStyle, context.lineCap] = [colour, "round"];
    for (let k = first + 1; k < points.length; ++k) {
      context.lineWidth = 1 + (ofPressure - 1) * points[k][2];
      context.beginPath();
      context.moveTo(points[k - 1][0], points[k - 1][1]);
      context.lineTo(points[k][0], points[k][1]);
      context.stroke();
    }
  }

  paint() {
    this.context.setTransform(1, 0, 0, 1, 0, 0);
    this.context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    this.acts.under?.(this);
    if (this.points) this.line(this.points);
  }

  twoFingers() {
    const [a, b] = [...this.fingers.values()];
    return [[(a[0] + b[0]) / 2, (a[1] + b[1]) / 2], Math.max(1, Math.hypot(a[0] - b[0], a[1] - b[1]))];
  }

  // The one that is more than the other, until the fingers are lifted.
  pair() {
    const [middle, apart] = this.twoFingers();
    if (this.does === "two") {
      const turned = Math.hypot(middle[0] - this.from[0], middle[1] - this.from[1]), spread = Math.abs(apart - this.apart);
      if (Math.max(turned, spread) <= still) return;
      this.does = turned > spread ? "turn" : "pinch";
      if (this.does === "turn") {
        this.acts.hand("MouseMoveEvent", ...this.from);
        this.acts.hand("MiddleButtonPressEvent", ...this.from);
      }
    }
    if (this.does === "turn") this.acts.hand("MouseMoveEvent", ...middle);
    if (this.does === "pinch") {
      this.acts.zoom(apart / this.apart, ...middle);
      this.apart = apart;
    }
    this.last = middle;
  }

  up(event) {
    const touched = this.fingers.delete(event.pointerId), [x, y] = this.at(event);
    if (touched && ["turn", "pinch", "two"].includes(this.does)) {
      if (this.fingers.size > 0) return;
      if (this.does === "turn") this.acts.hand("MiddleButtonReleaseEvent", ...this.last);
      this.does = "";
      return;
    }
    const points = this.points, does = this.does;
    if (does === "hand") return this.turn(event, "Release");
    this.giveUp();
    if (does === "drag") this.acts.dragged(this.from, [x, y], true);
    else if (does === "line" && points.length > 1) this.acts.line(points, event);
    else if (does === "line" || does === "wait") this.acts.tap?.(x, y);
  }

  cancel(event) {
    this.fingers.delete(event.pointerId);
    if (this.does === "hand") this.turn(event, "Release");
    this.giveUp();
  }

  giveUp() {
    if (this.does === "turn") this.acts.hand("MiddleButtonReleaseEvent", ...this.last);
    if (this.does === "drag") this.acts.dragged(this.from, this.from, false);
    this.points = null;
    this.does = "";
    this.paint();
  }
}

// A mouse says 0.5 whatever it does, and is pressed as one draws.
function pressure(event) {
  return event.pointerType === "pen" ? event.pressure : 1;
}

// Whether a line that ends where it began goes round a place.
export function inside(line, x, y) {
  const [a, b] = [line[0], line[line.length - 1]];
  if (Math.hypot(a[0] - b[0], a[1] - b[1]) > 0.02) return false;
  return line.filter(([px, py], k) => {
    const [qx, qy] = line[(k + 1) % line.length];
    return py > y !== qy > y && x < px + (y - py) / (qy - py) * (qx - px);
  }).length % 2 === 1;
}

// How far a place is from a line.
export function away(line, x, y) {
  let least = Infinity;
  for (let k = 1; k < line.length; ++k) {
    const [ax, ay] = line[k - 1], dx = line[k][0] - ax, dy = line[k][1] - ay;
    const share = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
    least = Math.min(least, Math.hypot(x - ax - share * dx, y - ay - share * dy));
  }
  return least;
}
