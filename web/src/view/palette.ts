// Colours by what they mean. Curves have those of the printed plots; each also differs in its dash.

export type Paint =
  | "paper" | "ink" | "faint" | "grid" | "band" | "exact" | "envelope" | "points" | "method" | "error" | "cursor"
  | "kinetic" | "potential" | "stokes" | "coulomb" | "newton" | "sum" | "spring" | `kept${0 | 1 | 2}`;
export type Palette = Record<Paint, string>;

const light: Palette = {
  paper: "#ffffff", ink: "#1c1b1a", faint: "#5c5955", grid: "#e6e3de", band: "#d9d9d9",
  exact: "#0072b2", envelope: "#c05200", points: "#222222", method: "#b3006b", error: "#b3006b", cursor: "#a3211d",
  kinetic: "#f0e442", potential: "#56b4e9", stokes: "#00805e", coulomb: "#c05200", newton: "#7b3f73",
  sum: "#1c1b1a", spring: "#0072b2", kept0: "#b3006b", kept1: "#7a6200", kept2: "#4b5563",
};
const dark: Palette = {
  paper: "#16181a", ink: "#e8e5df", faint: "#aba69e", grid: "#34383c", band: "#444a50",
  exact: "#56b4e9", envelope: "#f0a24a", points: "#f2f2f2", method: "#ff8fd0", error: "#ff8fd0", cursor: "#ff9a8f",
  kinetic: "#f0e442", potential: "#3d8fc4", stokes: "#2bc397", coulomb: "#ee7a1e", newton: "#c98bc0",
  sum: "#e8e5df", spring: "#56b4e9", kept0: "#ff8fd0", kept1: "#d8b93f", kept2: "#b8c0cc",
};

export const DASHES: Partial<Record<Paint, number[]>> = {
  envelope: [9, 5], method: [6, 3], stokes: [10, 4], coulomb: [2, 3], newton: [10, 3, 2, 3],
  kept0: [12, 4], kept1: [3, 3], kept2: [12, 3, 3, 3],
};

const darkWished = matchMedia("(prefers-color-scheme: dark)");
const onPaper = matchMedia("print");

export const printing = () => onPaper.matches;

/** The colours that hold now: paper is always light. */
export function palette(): Palette {
  const chosen = document.documentElement.dataset.theme ?? "system";
  const isDark = chosen === "dark" || (chosen === "system" && darkWished.matches);
  return isDark && !onPaper.matches ? dark : light;
}

/** Of exported pictures. */
export const printed = light;

/** Calls `draw` whenever the colours change. */
export function whenColoursChange(draw: () => void): void {
  darkWished.addEventListener("change", draw);
  onPaper.addEventListener("change", draw);
}

/** Lets the style sheet use the same colours. */
export function publish(): void {
  for (const [name, colour] of Object.entries(palette())) {
    document.documentElement.style.setProperty(`--${name}`, colour);
  }
}
