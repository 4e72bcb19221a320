//! The sections of the report on a recording as HTML: formulas in signs, and a place for each picture, which the page draws.

use federpendel_report::document::{Block, Row, Section};
use federpendel_report::plain;

/// Sections one after the other, each with a heading of the second level; a picture is a `figure` with its name and its
/// caption.
pub fn html(sections: &[Section]) -> String {
    let mut page = String::new();
    for section in sections {
        page += "<section>";
        tag("h2", &section.heading, &mut page);
        section.blocks.iter().for_each(|block| set(block, &mut page));
        page += "</section>";
    }
    page
}

fn set(block: &Block, page: &mut String) {
    match block {
        Block::Paragraph(words) | Block::Notice(words) => tag("p", words, page),
        Block::Formula { tex, .. } => {
            *page += "<p>";
            escape(&plain::formula(tex), page);
            *page += "</p>";
        }
        Block::List(items) => {
            *page += "<ul>";
            items.iter().for_each(|item| tag("li", item, page));
            *page += "</ul>";
        }
        Block::Figure { id, caption, .. } => {
            *page += "<figure data-name=\"";
            *page += id;
            *page += "\">";
            tag("figcaption", caption, page);
            *page += "</figure>";
        }
        Block::Table { caption, head, rows } => table(caption, head, rows, page),
        // Of the report on the article.
        Block::Sketch { .. } | Block::Claims(_) => {}
    }
}

fn table(caption: &str, head: &[String], rows: &[Row], page: &mut String) {
    *page += "<div class=\"wide\"><table>";
    tag("caption", caption, page);
    *page += "<thead><tr>";
    head.iter().for_each(|cell| tag("th scope=\"col\"", cell, page));
    *page += "</tr></thead><tbody>";
    for row in rows {
        *page += "<tr>";
        for (place, cell) in row.cells.iter().enumerate() {
            tag(if place == 0 { "th scope=\"row\"" } else { "td" }, cell, page);
        }
        *page += "</tr>";
    }
    *page += "</tbody></table></div>";
}

/// An element, `opening` being its name and its attributes, with a text of the report in it.
fn tag(opening: &str, text: &str, page: &mut String) {
    *page += "<";
    *page += opening;
    *page += ">";
    escape(&plain::text(text), page);
    *page += "</";
    *page += opening.split(' ').next().unwrap_or_default();
    *page += ">";
}

/// What a file says of itself is no part of the page.
fn escape(text: &str, page: &mut String) {
    for sign in text.chars() {
        match sign {
            '<' => *page += "&lt;",
            '>' => *page += "&gt;",
            '&' => *page += "&amp;",
            _ => page.push(sign),
        }
    }
}
