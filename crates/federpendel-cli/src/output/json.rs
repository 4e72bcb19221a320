//! Everything as JSON, with the fields of `schemas/simulation.schema.json`.

mod document;
mod tidy;

use std::io::{self, Write};

use serde::Serialize;
use serde_json::Serializer;

use crate::record::Record;
use document::Document;
use tidy::Tidy;

pub(super) fn write(record: &Record, out: &mut dyn Write) -> io::Result<()> {
    let document = Document::new(record).map_err(io::Error::other)?;
    document.serialize(&mut Serializer::with_formatter(&mut *out, Tidy::default()))?;
    out.write_all(b"\n")
}
