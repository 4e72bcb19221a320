//! The file system within an .xls, looked at before a library follows it: a table says of each sector which comes next,
//! and where that leads in a circle, reading would never end. [MS-CFB], sections 2.2, 2.3 and 2.5.

use super::error::ReadError;

/// Entries from here on are no sectors: the end of a chain, a sector that is free or of the table itself.
const SPECIAL: u32 = 0xffff_fffa;

fn damaged(reason: &str) -> ReadError {
    ReadError::Damaged { reason: reason.to_owned() }
}

fn number(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?))
}

/// Refuses a file whose sectors follow each other in a circle.
pub(super) fn check(bytes: &[u8]) -> Result<(), ReadError> {
    let table = table(bytes).ok_or_else(|| damaged("compound file cut off"))?;
    // 0 is not seen, else the number of the walk that came by.
    let mut seen = vec![0_usize; table.len()];
    for start in 0..table.len() {
        let mut at = start;
        while let Some(mark) = seen.get_mut(at) {
            if *mark == start + 1 {
                return Err(damaged("compound file with a circle of sectors"));
            }
            if *mark > 0 {
                break;
            }
            *mark = start + 1;
            at = table[at] as usize;
        }
    }
    if table.iter().any(|next| *next < SPECIAL && *next as usize >= table.len()) {
        return Err(damaged("compound file with a sector beyond its end"));
    }
    Ok(())
}

/// Which sector follows each.
fn table(bytes: &[u8]) -> Option<Vec<u32>> {
    let size = if bytes.get(30)? == &12 { 4096 } else { 512 };
    let entries = size / 4;
    let sector = |id: u32| bytes.chunks(size).nth((id as usize).checked_add(1)?);
    // Sectors of the table: 109 of them in the header, more in a chain of sectors.
    let mut parts: Vec<u32> = (0..109).map_while(|at| number(bytes, 76 + 4 * at)).collect();
    let mut more = number(bytes, 68)?;
    let most = bytes.len() / size + 1;
    for _ in 0..most {
        if more >= SPECIAL {
            break;
        }
        let part = sector(more)?;
        parts.extend((0..entries - 1).map_while(|at| number(part, 4 * at)));
        more = number(part, 4 * (entries - 1))?;
    }
    let mut table = Vec::new();
    for id in parts.into_iter().filter(|id| *id < SPECIAL).take(most) {
        let part = sector(id)?;
        table.extend((0..entries).map_while(|at| number(part, 4 * at)));
    }
    Some(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOOK: &[u8] = include_bytes!("../../tests/data/raw-data.xls");

    #[test]
    fn a_circle_of_sectors_is_refused() {
        assert_eq!(check(BOOK), Ok(()));
        let first = number(BOOK, 76).unwrap() as usize;
        let mut book = BOOK.to_vec();
        // The first sector follows itself.
        book[512 * (first + 1)..][..4].copy_from_slice(&[0; 4]);
        assert_eq!(check(&book), Err(damaged("compound file with a circle of sectors")));
        book[512 * (first + 1)..][..4].copy_from_slice(&[0, 0, 1, 0]);
        assert_eq!(check(&book), Err(damaged("compound file with a sector beyond its end")));
        assert_eq!(check(&BOOK[..520]), Err(damaged("compound file cut off")));
        assert!(check(&[]).is_err());
    }
}
