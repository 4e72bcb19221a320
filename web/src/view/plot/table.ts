// Numbers side by side as CSV.

export interface Column {
  head: string;
  values: ArrayLike<number>;
}

/** Significant digits of the largest number of a column; all of it have the same decimals, so that none needs an exponent. */
const DIGITS = 12;

function writer({ values }: Column): (row: number) => string {
  let largest = 0;
  for (let k = 0; k < values.length; k++) largest = Math.max(largest, Math.abs(values[k]!));
  const decimals = Math.min(100, Math.max(0, DIGITS - 1 - Math.floor(Math.log10(largest || 1))));
  return (row) => {
    const number = values[row]?.toFixed(decimals) ?? "";
    return (number.includes(".") ? number.replace(/\.?0+$/, "") : number).replace(/^-0$/, "0");
  };
}

/** Commas and points, or as German spreadsheets have it, which also take letters from a byte-order mark only. */
export function csv(columns: Column[], german: boolean): string {
  const separator = german ? ";" : ",";
  const quoted = (words: string) => (/[",;]/.test(words) ? `"${words.replaceAll('"', '""')}"` : words);
  const cells = columns.map(writer).map((write) => (german ? (row: number) => write(row).replace(".", ",") : write));
  const rows = Math.max(0, ...columns.map(({ values }) => values.length));
  const lines = Array.from({ length: rows }, (_, row) => cells.map((cell) => cell(row)).join(separator));
  return [(german ? "\uFEFF" : "") + columns.map(({ head }) => quoted(head)).join(separator), ...lines, ""].join("\n");
}
