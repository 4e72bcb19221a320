//! A plot as text, in braille dots.

use super::braille::Canvas;
use super::{colour, layers};
use crate::plot::thin::thin;
use crate::plot::ticks::{Tick, ticks};
use crate::plot::{Band, Dash, Marker, Plot, Role, Series, Span, Style};

/// Fewest columns and rows in which there is something to see.
const SMALLEST: (usize, usize) = (24, 8);

/// `plot` as lines of text, at most `columns` wide (from 40 on, but for a long word in the title) and about
/// `rows` high (the legend may need more); with `colour`, in the colours of the terminal.
pub fn terminal(plot: &Plot, columns: usize, rows: usize, colour: bool) -> String {
    let (columns, rows) = (columns.max(SMALLEST.0), rows.max(SMALLEST.1));
    let (x, y) = (plot.x_span(), plot.y_span());
    // Title, name of y, axis, tick labels, name of x and the legend stand around the canvas.
    let height = (rows - 6).max(4);
    let y_ticks = ticks(&y, (height / 3).clamp(2, 9), plot.language);
    let margin = y_ticks.iter().map(|tick| width(&tick.label)).max().unwrap_or(0) + 2;
    let mut canvas = Canvas::new(columns.saturating_sub(margin).max(8), height);
    let room = canvas.columns / 2;
    draw(plot, &mut canvas, &x, &y, room);
    let x_ticks = x_ticks(&x, canvas.columns, plot);

    let mut lines = title(&plot.title, columns);
    lines.push(plot.y.label.clone());
    lines.extend(body(&canvas, &y, &y_ticks, margin, colour));
    lines.extend(foot(&x, &x_ticks, margin, canvas.columns));
    lines.push(flush_right(&plot.x.label, columns));
    lines.extend(legend(plot, columns, room, colour));
    lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// The title, in as many lines as it needs.
fn title(title: &str, columns: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in title.split(' ') {
        match lines.last_mut().filter(|line| width(line) + 1 + width(word) <= columns) {
            Some(line) => *line = format!("{line} {word}"),
            None => lines.push(word.to_owned()),
        }
    }
    lines.iter().map(|line| centred(line, columns)).collect()
}

fn draw(plot: &Plot, canvas: &mut Canvas, x: &Span, y: &Span, room: usize) {
    for band in &plot.bands {
        draw_band(canvas, band, y);
    }
    let (width, height) = (canvas.width(), canvas.height());
    let place = |(x_value, y_value): (f64, f64)| {
        let (right, up) = (x.fraction(x_value)?, y.fraction(y_value)?);
        let at = |fraction: f64, dots: i64| (fraction * (dots - 1) as f64).round() as i64;
        Some((at(right, width), height - 1 - at(up, height)))
    };
    for series in layers(plot, room) {
        match series.style {
            Style::Line { dash, .. } => {
                let points = thin(&series.points, x, width as usize);
                if let Some(bead) = bead(series) {
                    let dots: Vec<_> = points.iter().copied().filter_map(place).collect();
                    canvas.beads(&dots, bead, series.role);
                    continue;
                }
                for pair in points.windows(2) {
                    if let (Some(from), Some(to)) = (place(pair[0]), place(pair[1])) {
                        canvas.line(from, to, dash, series.role);
                    }
                }
                // A single point has no line to be seen by.
                if let ([point], Some(at)) = (&points[..], points.first().copied().and_then(place))
                {
                    debug_assert!(point.0.is_finite());
                    canvas.put(at.0, at.1, '•', series.role);
                }
                for (point, lower) in series.points.iter().zip(series.lower.iter().flatten()) {
                    if let (Some(top), Some(bottom)) = (place(*point), place((point.0, *lower))) {
                        canvas.line(top, bottom, Dash::Solid, series.role);
                    }
                }
            }
            Style::Markers(marker) => {
                for (right, down) in series.points.iter().copied().filter_map(place) {
                    canvas.put(right, down, symbol(marker), series.role);
                }
            }
        }
    }
}

/// The edges of a band as dotted lines; shading would hide the curves.
fn draw_band(canvas: &mut Canvas, band: &Band, y: &Span) {
    for edge in [band.low, band.high] {
        let Some(up) = y.fraction(edge).filter(|up| (0.0..=1.0).contains(up)) else { continue };
        let down = canvas.height() - 1 - (up * (canvas.height() - 1) as f64).round() as i64;
        for right in (0..canvas.width()).step_by(4) {
            canvas.dot(right, down, None);
        }
    }
}

fn body(canvas: &Canvas, y: &Span, ticks: &[Tick], margin: usize, colour: bool) -> Vec<String> {
    let rows = canvas.rows;
    let row_of = |tick: &Tick| {
        let up = y.fraction(tick.value).unwrap_or(0.0);
        rows - 1 - ((up * rows as f64) as usize).min(rows - 1)
    };
    (0..rows)
        .map(|row| {
            let tick = ticks.iter().find(|tick| row_of(tick) == row);
            let label = tick.map_or("", |tick| &tick.label);
            let axis = if tick.is_some() { '┤' } else { '│' };
            let mut line = format!("{}{label} {axis}", " ".repeat(margin - 2 - width(label)));
            let mut current = None;
            for cell in canvas.row(row) {
                let role = cell.role.filter(|_| colour && cell.character() != ' ');
                if role != current {
                    line.push_str(&escape(role));
                    current = role;
                }
                line.push(cell.character());
            }
            if current.is_some() {
                line.push_str(&escape(None));
            }
            line
        })
        .collect()
}

/// The horizontal axis with its ticks, and the labels below them.
fn foot(x: &Span, ticks: &[Tick], margin: usize, columns: usize) -> [String; 2] {
    let mut axis = vec!['─'; columns];
    let mut labels = vec![' '; margin + columns];
    for tick in ticks {
        let column = column(x, tick.value, columns);
        axis[column] = '┬';
        for (place, sign) in label_start(tick, column, margin, columns).zip(tick.label.chars()) {
            labels[place] = sign;
        }
    }
    let corner = format!("{}└", " ".repeat(margin - 1));
    [corner + &String::from_iter(axis), String::from_iter(labels)]
}

/// The places of a label, centred below its tick but not beyond the end of the line.
fn label_start(
    tick: &Tick,
    column: usize,
    margin: usize,
    columns: usize,
) -> std::ops::Range<usize> {
    let length = width(&tick.label);
    let start =
        (margin + column).saturating_sub(length / 2).min((margin + columns).saturating_sub(length));
    start..(start + length).min(margin + columns)
}

/// As many ticks as leave two spaces between their labels.
fn x_ticks(x: &Span, columns: usize, plot: &Plot) -> Vec<Tick> {
    let most = (columns / 7).clamp(2, 12);
    let fits = |ticks: &Vec<Tick>| {
        let places =
            ticks.iter().map(|tick| label_start(tick, column(x, tick.value, columns), 8, columns));
        let places: Vec<_> = places.collect();
        places.windows(2).all(|pair| pair[0].end + 2 <= pair[1].start)
    };
    (2..=most).rev().map(|most| ticks(x, most, plot.language)).find(fits).unwrap_or_default()
}

fn column(x: &Span, value: f64, columns: usize) -> usize {
    let fraction = x.fraction(value).unwrap_or(0.0).clamp(0.0, 1.0);
    ((fraction * (2 * columns - 1) as f64).round() as usize / 2).min(columns - 1)
}

/// The legend, as many entries to a line as fit.
fn legend(plot: &Plot, columns: usize, room: usize, colour: bool) -> Vec<String> {
    let listed = |series: &&Series| !series.name.is_empty() && super::has_room(series, room);
    let series = plot.series.iter().filter(listed).map(|series| {
        let sample = match series.style {
            _ if bead(series).is_some() => bead(series).map_or_else(String::new, beads),
            Style::Line { dash: Dash::Solid, .. } => "───".to_owned(),
            Style::Line { dash: Dash::Dashed | Dash::LongDashed, .. } => "╶╴╶╴".to_owned(),
            Style::Line { dash: Dash::Dotted, .. } => "····".to_owned(),
            Style::Markers(marker) => symbol(marker).to_string(),
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

/// The sign of which a broken line held beside a motion is made.
fn bead(series: &Series) -> Option<char> {
    match (series.role, series.style) {
        (Role::Comparison(n), Style::Line { dash: Dash::LongDashed, .. }) => {
            Some(['×', '+', 'o'][n % 3])
        }
        _ => None,
    }
}

fn beads(sign: char) -> String {
    [sign.to_string(), sign.to_string()].join(" ")
}

fn symbol(marker: Marker) -> char {
    match marker {
        Marker::Circle => '●',
        Marker::Diamond => '◆',
        Marker::Square => '■',
        Marker::Triangle => '▲',
    }
}

fn escape(role: Option<Role>) -> String {
    format!("\x1b[{}m", role.map_or(0, colour::ansi))
}

/// Columns that a text takes; the catalogue's signs are all one column wide.
fn width(text: &str) -> usize {
    text.chars().count()
}

fn centred(text: &str, columns: usize) -> String {
    format!("{}{text}", " ".repeat(columns.saturating_sub(width(text)) / 2))
}

fn flush_right(text: &str, columns: usize) -> String {
    format!("{}{text}", " ".repeat(columns.saturating_sub(width(text))))
}
