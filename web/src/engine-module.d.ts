/** The engine's module, compressed, as base64; made by the build. */
declare module 'virtual:engine' {
  const packed: string;
  export default packed;
}

/** The half of the library lzma1 that unpacks; see vite.config.ts. */
declare module 'lzma1/decoder' {
  import type { InputBuffer, OutputBuffer } from 'lzma1/streams';
  export class Decoder {
    decompress(packed: InputBuffer, unpacked: OutputBuffer): void;
  }
}

declare module 'lzma1/streams' {
  export class InputBuffer {
    constructor(bytes: Uint8Array);
  }
  export class OutputBuffer {
    constructor(size: number);
    toArray(): Uint8Array;
  }
}
