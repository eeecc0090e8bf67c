// The last picture, which a browser moves and scales as it is where painting anew would take longer than a frame.
"use strict";
import { byId } from "./elements.js";
import { paint } from "./paint.js";

/** Milliseconds without a move after which the picture is painted anew. */
const STILL = 90;
/** Shapes and lines beyond which painting may take longer than a frame. */
const MUCH = 600;

/** Milliseconds between two moves up to which the second goes on with the first. */
const ONE_MOVE = 600;

const held = { scene: null, view: null, timer: 0, last: 0 };

/** Paints, and keeps what is large for {@link moved}. */
export function paintAnew(canvas, scene, view, marks, colours) {
  paint(canvas, scene, view, marks, colours);
  byId("moving").hidden = true;
  Object.assign(held, { view, scene: scene.items.length + scene.lines.length > MUCH ? scene : null });
}

/**
 * Shows the last picture where it belongs in another view, and has it painted anew when nothing has moved for a moment.
 * @returns {boolean} false where there is none of this scene
 */
export function moved(canvas, scene, view, repaint) {
  if (held.scene === null || held.scene !== scene) return false;
  const holder = byId("moving"), copy = holder.querySelector("canvas");
  if (holder.hidden) {
    Object.assign(copy, { width: canvas.width, height: canvas.height });
    copy.getContext("2d", { alpha: false }).drawImage(canvas, 0, 0);
    holder.hidden = false;
  }
  const k = view.k / held.view.k;
  copy.style.transform = `translate(${view.x - held.view.x * k}px, ${view.y - held.view.y * k}px) scale(${k})`;
  const now = performance.now(), since = now - held.last;
  held.last = now;
  clearTimeout(held.timer);
  // A browser that is busy gets fewer frames: to paint anew between them would make that worse.
  held.timer = setTimeout(repaint, since < ONE_MOVE ? Math.max(STILL, 2 * since) : STILL);
  return true;
}
