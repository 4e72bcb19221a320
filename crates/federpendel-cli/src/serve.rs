//! `federpendel serve`: the page in the browser, from this program alone.

use std::io::{self, Write};
use std::net::Ipv4Addr;
use std::thread;

use federpendel_text::Catalogue;
use tiny_http::{Header, Method, Request, Response, Server};

use crate::args::Serve;
use crate::failure::{Failure, note};

/// The page, if the program was built with it.
#[cfg(feature = "page")]
const PAGE: Option<&[u8]> = Some(include_bytes!("../../../web/dist/federpendel.html"));
#[cfg(not(feature = "page"))]
const PAGE: Option<&[u8]> = None;

pub(crate) fn run(arguments: &Serve, catalogue: &Catalogue) -> Result<(), Failure> {
    let port = port(arguments, catalogue)?;
    let page = PAGE.ok_or_else(|| Failure::Input(catalogue.text("serve-no-page")))?;
    let refused = |error: &io::Error| {
        let variables = [("port", port.to_string().into()), ("problem", error.to_string().into())];
        Failure::System(catalogue.format("serve-port-taken", &variables))
    };
    // Of this machine alone: nobody else in the network reaches it.
    let server = Server::http((Ipv4Addr::LOCALHOST, port)).map_err(|error| {
        refused(&error.downcast::<io::Error>().map_or_else(io::Error::other, |error| *error))
    })?;
    let address = server.server_addr().to_ip().map_or(port, |address| address.port());
    let address = format!("http://{}:{address}/", Ipv4Addr::LOCALHOST);
    let said = catalogue.format("serve-address", &[("address", address.as_str().into())]);
    // Whoever reads a pipe waits for this line.
    let mut out = io::stdout();
    writeln!(out, "{said}").and_then(|()| out.flush()).map_err(|_| Failure::BrokenPipe)?;
    if arguments.open && open::that_detached(&address).is_err() {
        note(&catalogue.text("serve-no-browser"));
    }
    for request in server.incoming_requests() {
        // Each on its own: a request whose body never comes makes nobody else wait. A browser that has gone away wants no
        // answer.
        thread::spawn(move || answer(request, page));
    }
    Ok(())
}

/// The port that is asked for; 0 for any that is free.
fn port(arguments: &Serve, catalogue: &Catalogue) -> Result<u16, Failure> {
    let Some(written) = &arguments.port else { return Ok(0) };
    let port = written.trim().parse().ok().filter(|port| *port > 0);
    port.ok_or_else(|| {
        let value = catalogue.quoted(&federpendel_text::excerpt(written));
        Failure::Input(catalogue.format("serve-no-port", &[("value", value.into())]))
    })
}

fn answer(request: Request, page: &[u8]) -> io::Result<()> {
    let path = request.url().split(['?', '#']).next().unwrap_or_default();
    match (request.method(), path) {
        (Method::Get | Method::Head, "/" | "/federpendel.html") => {
            let header = |name: &str, value: &str| Header::from_bytes(name, value);
            let headers = [
                header("Content-Type", "text/html; charset=utf-8"),
                header("Cache-Control", "no-cache"),
                header("X-Content-Type-Options", "nosniff"),
            ];
            // With its length, not in pieces.
            let mut response = Response::from_data(page).with_chunked_threshold(usize::MAX);
            headers.into_iter().flatten().for_each(|header| response.add_header(header));
            request.respond(response)
        }
        (Method::Get | Method::Head, _) => request.respond(Response::empty(404)),
        _ => request.respond(Response::empty(405)),
    }
}
