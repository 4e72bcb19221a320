//! The legend of a plot in a terminal.

use super::areas;
use super::terminal::{escape, width};
use crate::plot::{Dash, Marker, Plot, Role, Series, Style};

/// The legend, as many entries to a line as fit.
pub(super) fn legend(plot: &Plot, columns: usize, room: usize, colour: bool) -> Vec<String> {
    let listed = |series: &&Series| !series.name.is_empty() && super::has_room(series, room);
    let series = plot.series.iter().filter(listed).map(|series| {
        let sample = match series.style {
            _ if series.lower.is_some() => areas::sample(series.role),
            _ if bead(series).is_some() => bead(series).map_or_else(String::new, beads),
            Style::Line { dash: Dash::Solid, .. } => "───".to_owned(),
            Style::Line { dash: Dash::Dashed | Dash::LongDashed, .. } => "╶╴╶╴".to_owned(),
            Style::Line { dash: Dash::Dotted, .. } => "····".to_owned(),
            Style::Markers(marker) => symbol(marker).to_string(),
            Style::Marked { marker, .. } => format!("─{}─", symbol(marker)),
        };
        (sample, Some(series.role), &series.name)
    });
    let bands = plot.bands.iter().map(|band| ("⠁⠁⠁".to_owned(), None, &band.name));
    let mut lines = vec![String::new()];
    let mut used = 0;
    for (sample, role, name) in series.chain(bands) {
        let length = width(&sample) + 1 + width(name);
        if used > 0 && used + 3 + length > columns {
            lines.push(String::new());
            used = 0;
        }
        let gap = if used > 0 { "   " } else { "" };
        used += gap.len() + length;
        let (on, off) = match role.filter(|_| colour) {
            Some(role) => (escape(Some(role)), escape(None)),
            None => Default::default(),
        };
        if let Some(line) = lines.last_mut() {
            line.push_str(&format!("{gap}{on}{sample}{off} {name}"));
        }
    }
    lines
}

/// The sign of which a line is made that would be lost in dots, and in one of how many cells it stands: a
/// broken line held beside a motion, and a bar.
pub(super) fn bead(series: &Series) -> Option<(char, usize)> {
    match (series.role, series.style) {
        (Role::Comparison(n), Style::Line { dash: Dash::LongDashed, .. }) => {
            Some((['×', '+', 'o'][n % 3], 2))
        }
        (Role::Sticking, _) => Some(('━', 1)),
        _ => None,
    }
}

fn beads((sign, every): (char, usize)) -> String {
    if every == 1 { sign.to_string().repeat(3) } else { format!("{sign} {sign}") }
}

pub(super) fn symbol(marker: Marker) -> char {
    match marker {
        Marker::Circle => '●',
        Marker::Diamond => '◆',
        Marker::Square => '■',
        Marker::Triangle => '▲',
        Marker::TriangleDown => '▼',
        Marker::Cross => '×',
        Marker::Plus => '+',
        Marker::Star => '★',
        Marker::Pentagon => '◇',
        Marker::Hexagon => '△',
        Marker::Ring => '○',
        Marker::Frame => '□',
    }
}
