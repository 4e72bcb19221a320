// Which laws and quantities have a say in an experiment.

import type { Experiment, Law } from "../engine";

/** The law whose motion a quantity changes; none for mass, spring and release. */
export const LAW_OF: Record<string, Law> = {
  damping: "stokes", kinetic: "coulomb", static: "coulomb", gravity: "coulomb", normal_force: "coulomb",
  density: "newton", drag_coefficient: "newton", area: "newton",
};

export function matters({ laws, hanging }: Experiment, name: string): boolean {
  if (name === (hanging ? "gravity" : "normal_force") || name === "duration") return false;
  const law = LAW_OF[name];
  return !law || laws[law];
}

/** The laws by those who found them: the same names in every language. */
export const acting = ({ laws }: Experiment): string[] =>
  (["stokes", "coulomb", "newton"] as const).filter((law) => laws[law]).map((law) => law[0]!.toUpperCase() + law.slice(1));
