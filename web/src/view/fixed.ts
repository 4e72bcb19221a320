// Numbers whose digits stand still while they change.

import { formatOf } from "./plot/ticks";

/** So many decimals that the largest value has four digits. */
export const decimals = (largest: number) =>
  largest > 0 ? Math.min(9, Math.max(0, 3 - Math.floor(Math.log10(largest) + 1e-9))) : 3;

export const fixed = (language: string, value: number, places: number) =>
  formatOf(language, places, false).format(Number(value.toFixed(places)) || 0).replace("-", "−");

/** The largest of the values, whatever its sign. */
export const largest = (values: Iterable<number>) => {
  let most = 0;
  for (const value of values) most = Math.max(most, Math.abs(value));
  return most;
};
