// One way to draw, on a canvas as in an SVG file.

export interface Pen {
  /** Height of letters, pixels. */
  size: number;
  line(points: number[], colour: string, width: number, dash?: number[]): void;
  /** A closed shape. */
  shape(points: number[], colour: string): void;
  dot(x: number, y: number, radius: number, colour: string): void;
  text(words: string, x: number, y: number, colour: string, anchor: "start" | "middle" | "end"): void;
  width(words: string): number;
  /** Draws only within the rectangle what `draw` draws. */
  clip(x: number, y: number, width: number, height: number, draw: () => void): void;
}

const PRINTED_SIZE = 13;
const FAMILY = "system-ui, 'Segoe UI', Roboto, 'DejaVu Sans', sans-serif";

function path(at: CanvasRenderingContext2D, points: number[]): void {
  at.beginPath();
  at.moveTo(points[0]!, points[1]!);
  for (let i = 2; i < points.length; i += 2) at.lineTo(points[i]!, points[i + 1]!);
}

export function canvasPen(at: CanvasRenderingContext2D, size = PRINTED_SIZE): Pen {
  at.font = `${size}px ${FAMILY}`;
  at.lineJoin = "round";
  return {
    size,
    line(points, colour, width, dash = []) {
      path(at, points);
      at.strokeStyle = colour;
      at.lineWidth = width;
      at.setLineDash(dash);
      at.stroke();
    },
    shape(points, colour) {
      path(at, points);
      at.fillStyle = colour;
      at.fill();
    },
    dot(x, y, radius, colour) {
      at.beginPath();
      at.arc(x, y, radius, 0, 2 * Math.PI);
      at.fillStyle = colour;
      at.fill();
    },
    text(words, x, y, colour, anchor) {
      at.fillStyle = colour;
      at.textAlign = anchor === "middle" ? "center" : anchor;
      at.fillText(words, x, y);
    },
    width: (words) => at.measureText(words).width,
    clip(x, y, width, height, draw) {
      at.save();
      at.beginPath();
      at.rect(x, y, width, height);
      at.clip();
      draw();
      at.restore();
    },
  };
}

const short = (value: number) => String(Math.round(value * 100) / 100);
const escaped = (words: string) => words.replace(/[&<>"]/g, (sign) => `&#${sign.charCodeAt(0)};`);

function pairs(points: number[]): string {
  let words = "";
  for (let i = 0; i < points.length; i += 2) words += `${short(points[i]!)},${short(points[i + 1]!)} `;
  return words.trimEnd();
}

/** A pen that writes into `parts`; `ruler` measures texts, `name` begins the ids, which a page may hold but once. */
export function svgPen(parts: string[], ruler: Pen, name: string): Pen {
  let clips = 0;
  return {
    size: PRINTED_SIZE,
    line(points, colour, width, dash = []) {
      const broken = dash.length > 0 ? ` stroke-dasharray="${dash.join(" ")}"` : "";
      parts.push(`<polyline points="${pairs(points)}" fill="none" stroke="${colour}" stroke-width="${width}" stroke-linejoin="round"${broken}/>`);
    },
    shape(points, colour) {
      parts.push(`<polygon points="${pairs(points)}" fill="${colour}"/>`);
    },
    dot(x, y, radius, colour) {
      parts.push(`<circle cx="${short(x)}" cy="${short(y)}" r="${radius}" fill="${colour}"/>`);
    },
    text(words, x, y, colour, anchor) {
      parts.push(`<text x="${short(x)}" y="${short(y)}" fill="${colour}" text-anchor="${anchor}">${escaped(words)}</text>`);
    },
    width: (words) => ruler.width(words),
    clip(x, y, width, height, draw) {
      const id = `${name}-within-${++clips}`;
      parts.push(`<clipPath id="${id}"><rect x="${short(x)}" y="${short(y)}" width="${short(width)}" height="${short(height)}"/></clipPath><g clip-path="url(#${id})">`);
      draw();
      parts.push("</g>");
    },
  };
}

export interface Size {
  width: number;
  height: number;
}

/** Opens an SVG document around what a pen wrote. */
export function svgDocument(parts: string[], name: string, size: Size, title: string, description: string, paper: string): string {
  const { width, height } = size;
  return (
    `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" ` +
    `role="img" aria-labelledby="${name}-title ${name}-description" font-family="${FAMILY}" font-size="${PRINTED_SIZE}">` +
    `<title id="${name}-title">${escaped(title)}</title><desc id="${name}-description">${escaped(description)}</desc>` +
    `<rect width="100%" height="100%" fill="${paper}"/>${parts.join("\n")}</svg>\n`
  );
}
