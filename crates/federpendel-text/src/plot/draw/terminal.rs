//! A plot as text, in braille dots.

use super::braille::Canvas;
use super::key::{bead, legend, symbol};
use super::{areas, colour, layers, marks};
use crate::plot::clip::clip;
use crate::plot::thin::thin;
use crate::plot::ticks::{Tick, ticks};
use crate::plot::{Band, Plot, Role, Series, Span};

/// Fewest columns and rows in which there is something to see.
const SMALLEST: (usize, usize) = (24, 8);

/// `plot` as lines of text, at most `columns` wide (from 40 on, but for a long word in the title) and about
/// `rows` high (the legend may need more); with `colour`, in the colours of the terminal.
pub fn terminal(plot: &Plot, columns: usize, rows: usize, colour: bool) -> String {
    let (columns, rows) = (columns.max(SMALLEST.0), rows.max(SMALLEST.1));
    let mut lines = panel(plot, columns, rows, colour);
    if let Some(lens) = &plot.lens {
        lines.push(String::new());
        lines.extend(panel(lens, columns, rows, colour));
    }
    lines.extend(legend(plot, columns, columns / 2, colour));
    lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// Title and axes with what is drawn between them.
fn panel(plot: &Plot, columns: usize, rows: usize, colour: bool) -> Vec<String> {
    let (mut x, mut y) = (plot.x_span(), plot.y_span());
    // Title, name of y, axis, tick labels, name of x and the legend stand around the canvas.
    let height = (rows - 6).max(4);
    if plot.equal_scales {
        // Dots are about square, two by four in a cell.
        (x, y) = Span::equal(x, y, 2.0 * (columns - 4) as f64, 4.0 * height as f64);
    }
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
    lines
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
    areas::draw(plot, canvas, x, y);
    for series in layers(plot, room).into_iter().filter(|series| series.lower.is_none()) {
        draw_line(canvas, series, (x, y), place);
        if let Some(marker) = series.style.marker() {
            let number = if let Role::Comparison(n) = series.role { n } else { 0 };
            for (right, down) in marks(series, number, x, y).into_iter().filter_map(place) {
                canvas.put(right, down, symbol(marker), series.role);
            }
        }
    }
    for note in &plot.notes {
        if let Some(at) = place(note.point) {
            draw_note(canvas, &note.text, at);
        }
    }
}

/// A text about a dot, but not beyond the canvas; a row higher where it would cover markers.
fn draw_note(canvas: &mut Canvas, text: &str, (right, down): (i64, i64)) {
    let length = 2 * width(text) as i64;
    let start = (right - length / 2).min(canvas.width() - length).max(0);
    let free = |down: &i64| {
        *down >= 0 && !(start..start + length).any(|right| canvas.has_sign(right, *down))
    };
    let down = [down, down - 4].into_iter().find(free).unwrap_or(down);
    for (at, sign) in (start..).step_by(2).zip(text.chars()) {
        canvas.put(at, down, sign, Role::Guide);
    }
}

/// The line of a series, if it has one.
fn draw_line(
    canvas: &mut Canvas,
    series: &Series,
    (x, y): (&Span, &Span),
    place: impl Fn((f64, f64)) -> Option<(i64, i64)>,
) {
    let Some(dash) = series.style.dash() else { return };
    let points = thin(&series.points, x, canvas.width() as usize);
    for piece in clip(&points, x, y) {
        let dots: Vec<_> = piece.into_iter().filter_map(&place).collect();
        match (bead(series), &dots[..]) {
            // A single point has no line to be seen by.
            (_, [at]) => canvas.put(at.0, at.1, '•', series.role),
            (Some((bead, every)), dots) => canvas.beads(dots, bead, every, series.role),
            (None, dots) => {
                for pair in dots.windows(2) {
                    canvas.line(pair[0], pair[1], dash, series.role);
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

pub(super) fn escape(role: Option<Role>) -> String {
    format!("\x1b[{}m", role.map_or(0, colour::ansi))
}

/// Columns that a text takes; the catalogue's signs are all one column wide.
pub(super) fn width(text: &str) -> usize {
    text.chars().count()
}

fn centred(text: &str, columns: usize) -> String {
    format!("{}{text}", " ".repeat(columns.saturating_sub(width(text)) / 2))
}

fn flush_right(text: &str, columns: usize) -> String {
    format!("{}{text}", " ".repeat(columns.saturating_sub(width(text))))
}
