// One file: script and style stand in the page itself, and the engine within the script, compressed.

import { existsSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { compress } from 'lzma1';
import { defineConfig, type Plugin } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';

const NAME = 'virtual:engine';
const MODULE = new URL('src/wasm/federpendel_bg.wasm', import.meta.url);
const PACKED = new URL('src/wasm/federpendel.lzma', import.meta.url);

/** The module as LZMA; packing takes seconds, so it is kept beside it. */
function packed(): Buffer {
  if (!existsSync(PACKED) || statSync(PACKED).mtimeMs < statSync(MODULE).mtimeMs) {
    writeFileSync(PACKED, compress(readFileSync(MODULE), 9));
  }
  return readFileSync(PACKED);
}

/** The engine's module as base64 of its LZMA, a fifth smaller than what a browser unpacks by itself. */
function engine(): Plugin {
  return {
    name: 'engine',
    resolveId: (id) => (id === NAME ? `\0${NAME}` : undefined),
    load(id) {
      if (id !== `\0${NAME}`) return undefined;
      return `export default ${JSON.stringify(packed().toString('base64'))};`;
    },
  };
}

export default defineConfig({
  root: new URL('.', import.meta.url).pathname,
  plugins: [engine(), viteSingleFile()],
  // The page unpacks and never packs: of the library only that half.
  resolve: { alias: [{ find: /^lzma1\/(decoder|streams)$/, replacement: new URL('node_modules/lzma1/lib/$1.js', import.meta.url).pathname }] },
  build: {
    target: 'es2022',
    outDir: 'dist',
    rollupOptions: { input: new URL('index.html', import.meta.url).pathname },
  },
});
