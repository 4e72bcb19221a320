// Round numbers along an axis.

export interface Tick {
  value: number;
  label: string;
}

/** Making one takes longer than using it a thousand times. */
const formats = new Map<string, Intl.NumberFormat>();

/** Of a number with `decimals` decimals, those of its mantissa where it is scientific. */
export function formatOf(language: string, decimals: number, scientific: boolean): Intl.NumberFormat {
  const key = `${language} ${scientific ? "e" : ""}${decimals}`;
  const known = formats.get(key);
  if (known) return known;
  const made = new Intl.NumberFormat(language, scientific
    ? { notation: "scientific", maximumFractionDigits: decimals }
    : { minimumFractionDigits: decimals, maximumFractionDigits: decimals, useGrouping: false });
  formats.set(key, made);
  return made;
}

/** `1.5E-7` as it is written by hand. */
const raised = (number: string) =>
  number.replace(/E(.*)/, (_, power: string) => `·10${[...power].map((sign) => "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(sign)] ?? "⁻").join("")}`);

/** About `count` round values within the range, written in `language`. */
export function ticks([from, to]: [number, number], count: number, language: string): Tick[] {
  const rough = (to - from) / Math.max(1, count);
  if (!(rough > 0) || !Number.isFinite(rough)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((factor) => factor * power >= rough) ?? 10);
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const most = Math.max(Math.abs(from), Math.abs(to));
  const scientific = decimals > 5 || most >= 1e6;
  // As many digits as tell neighbours apart.
  const digits = Math.min(20, Math.max(0, Math.ceil(Math.log10(most / step) - 1e-9)));
  const format = formatOf(language, scientific ? digits : Math.min(20, decimals), scientific);
  const first = Math.ceil(from / step - 1e-9);
  // Beyond 2^53 counting up changes nothing: such a range has no round numbers of its own.
  const many = Math.floor(to / step + 1e-9) - first + 1;
  if (!Number.isSafeInteger(first + many)) return [];
  return Array.from({ length: many }, (_, k) => (first + k) * step)
    .map((value) => ({ value, label: value === 0 && scientific ? "0" : raised(format.format(value === 0 ? 0 : value)).replace("-", "−") }));
}
