//! Any bytes as a recording: refused, or finite values at rising times, and the same when they come in pieces. The first
//! byte chooses what is asked for.
#![no_main]

use std::io::{self, Cursor, Read, Seek, SeekFrom};

use federpendel_fit::Quantity;
use federpendel_fit::read::{Choice, LARGEST_NUMBER, LEAST_ROWS, recordings, recordings_from};
use libfuzzer_sys::fuzz_target;

/// What the bits of a byte ask for.
fn choice(bits: u8) -> Choice {
    let asked = |bit: u8, text: &str| (bits & bit != 0).then(|| text.to_owned());
    Choice {
        time: asked(16, "1"),
        value: asked(1, "2"),
        quantity: (bits & 2 != 0).then_some(Quantity::Velocity),
        unit: asked(32, "cm"),
        run: asked(4, "1"),
        table: None,
        rate: (bits & 8 != 0).then_some(100.0),
    }
}

/// Hands out one to seven bytes at a time.
struct Pieces<'a>(Cursor<&'a [u8]>);

impl Read for Pieces<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let most = buffer.len().min(1 + self.0.position() as usize % 7);
        self.0.read(&mut buffer[..most])
    }
}

impl Seek for Pieces<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        self.0.seek(to)
    }
}

fuzz_target!(|bytes: &[u8]| {
    let Some((first, bytes)) = bytes.split_first() else { return };
    // A line's end in front leaves everything to the reader, as most files do.
    let choice = if *first == b'\n' { Choice::default() } else { choice(*first) };
    let read = recordings(bytes, &choice);
    assert_eq!(recordings_from(Pieces(Cursor::new(bytes)), &choice), read);
    match read {
        Ok(reads) => {
            assert!(!reads.is_empty());
            for read in reads {
                let recording = &read.recording;
                assert!(recording.times.len() >= LEAST_ROWS);
                assert_eq!(recording.times.len(), recording.values.len());
                assert!(recording.times.is_sorted_by(|a, b| a < b), "{:?}", recording.times);
                // A unit of time may make an hour of a second.
                let most = 1e4 * LARGEST_NUMBER;
                assert!(recording.times.iter().chain(&recording.values).all(|x| x.abs() <= most));
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});
