//! Lines, arrows and labels of a drawing.

use federpendel_text::Catalogue;

use super::label;

/// A point of a drawing: to the right and down, in units of the drawing.
pub type Point = (f64, f64);

/// Length and half the width of an arrow's head.
const HEAD: (f64, f64) = (13.0, 4.5);

/// Where a label stands beside its point.
#[derive(Clone, Copy)]
pub enum Anchor {
    Start,
    Middle,
    End,
}

/// Draws.
#[derive(Default)]
pub struct Pen(String);

impl Pen {
    /// What `draw` draws belongs to `class`, which may have a colour and a width of line.
    pub fn group(&mut self, class: &str, draw: impl FnOnce(&mut Self)) {
        self.0 += &format!("<g class=\"{class}\">");
        draw(self);
        self.0 += "</g>";
    }

    /// Straight from point to point.
    pub fn line(&mut self, points: &[Point]) {
        self.path(points, "");
    }

    /// Around an area.
    pub fn outline(&mut self, points: &[Point]) {
        self.path(points, "Z");
    }

    fn path(&mut self, points: &[Point], end: &str) {
        let corners: Vec<_> = points.iter().map(|(x, y)| format!("{x:.1} {y:.1}")).collect();
        self.0 += &format!("<path d=\"M{}{end}\"/>", corners.join("L"));
    }

    pub fn circle(&mut self, (x, y): Point, radius: f64) {
        self.ellipse((x, y), (radius, radius));
    }

    pub fn ellipse(&mut self, (x, y): Point, (half_width, half_height): Point) {
        let ellipse = format!(
            "<ellipse cx=\"{x:.1}\" cy=\"{y:.1}\" rx=\"{half_width}\" ry=\"{half_height}\"/>"
        );
        self.0 += &ellipse;
    }

    /// A line with a head at its end.
    pub fn arrow(&mut self, from: Point, to: Point) {
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let along = ((to.0 - from.0) / length, (to.1 - from.1) / length);
        let corner = |side: f64| {
            (to.0 - HEAD.0 * along.0 - side * along.1, to.1 - HEAD.0 * along.1 + side * along.0)
        };
        // The shaft ends within the head, so that the tip stays sharp.
        self.line(&[from, (to.0 - 0.8 * HEAD.0 * along.0, to.1 - 0.8 * HEAD.0 * along.1)]);
        self.group("head", |pen| pen.outline(&[to, corner(HEAD.1), corner(-HEAD.1)]));
    }

    /// A label whose symbols stand between dollar signs: `$F_R$ = 2 N`.
    pub fn label(&mut self, (x, y): Point, anchor: Anchor, text: &str) {
        let anchor = match anchor {
            Anchor::Start => "start",
            Anchor::Middle => "middle",
            Anchor::End => "end",
        };
        let set = label::set(text);
        self.0 += &format!("<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{set}</text>");
    }

    /// The whole drawing, of this width and height, with what is said to who does not see it.
    pub fn finish(self, id: &str, size: Point, says: &Said) -> String {
        let (width, height) = size;
        let (title, description) = (escape(&says.title), escape(&says.description));
        format!(
            "<svg viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" role=\"img\" \
             aria-labelledby=\"{id}-title {id}-description\" fill=\"none\" stroke=\"currentColor\" \
             stroke-width=\"1.5\" stroke-linejoin=\"round\" font-size=\"21\">\
             <title id=\"{id}-title\">{title}</title><desc id=\"{id}-description\">{description}</desc>\
             {}</svg>",
            self.0
        )
    }
}

/// Title and description of a drawing.
pub struct Said {
    pub title: String,
    pub description: String,
}

impl Said {
    /// Those of a drawing about which there is nothing to fill in.
    pub fn plain(catalogue: &Catalogue, title: &str, description: &str) -> Self {
        Self { title: catalogue.text(title), description: catalogue.text(description) }
    }
}

pub(super) fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
