//! The page from the program: what is refused, and with the feature `page` the page itself.

mod common;

use common::Workplace;

#[test]
fn a_port_that_is_none_is_refused() {
    for port in ["x", "0", "-1", "70000", "80 80"] {
        let run = Workplace::new().run(&["serve", "--no-open", "--port", port]);
        assert_eq!((run.status, run.out.as_str()), (Some(2), ""), "{port}");
        assert!(run.err.contains("--port") && run.err.contains(port.trim()), "{}", run.err);
    }
}

#[cfg(not(feature = "page"))]
#[test]
fn without_the_page_it_is_said_how_to_get_it() {
    for language in ["en", "de"] {
        let run = Workplace::new().run(&["serve", "--no-open", "--lang", language]);
        assert_eq!((run.status, run.out.as_str()), (Some(2), ""));
        assert!(
            run.err.contains("web/build") && run.err.contains("--features page"),
            "{}",
            run.err
        );
    }
}

#[cfg(feature = "page")]
mod with_the_page {
    use std::io::{BufRead, BufReader, Read, Write};
    use std::net::TcpStream;
    use std::process::{Child, Command, Stdio};

    /// The program while it serves; it ends with this, also where a test fails.
    struct Served {
        program: Child,
        address: String,
    }

    impl Served {
        fn start() -> Self {
            let mut program = Command::new(env!("CARGO_BIN_EXE_federpendel"))
                .args(["serve", "--no-open", "--lang", "en"])
                .stdout(Stdio::piped())
                .spawn()
                .expect("the program");
            let mut line = String::new();
            BufReader::new(program.stdout.take().unwrap()).read_line(&mut line).unwrap();
            let address = line.split("http://").nth(1).and_then(|rest| rest.split('/').next());
            let address = address.expect("an address").to_owned();
            Self { program, address }
        }
    }

    impl Drop for Served {
        fn drop(&mut self) {
            let _ = self.program.kill();
            let _ = self.program.wait();
        }
    }

    fn get(address: &str, path: &str) -> (String, Vec<u8>) {
        let mut stream = TcpStream::connect(address).expect("a server");
        stream.set_read_timeout(Some(std::time::Duration::from_secs(5))).unwrap();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {address}\r\nConnection: close\r\n\r\n")
            .unwrap();
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).unwrap();
        let end = answer.windows(4).position(|four| four == b"\r\n\r\n").expect("headers");
        (String::from_utf8_lossy(&answer[..end]).into_owned(), answer[end + 4..].to_vec())
    }

    #[test]
    fn a_body_that_never_comes_keeps_nobody_waiting() {
        let served = Served::start();
        let mut silent = TcpStream::connect(&served.address).expect("a server");
        write!(silent, "POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 50000\r\n\r\n").unwrap();
        std::thread::sleep(std::time::Duration::from_millis(200));
        let (headers, _) = get(&served.address, "/Cargo.toml");
        assert!(headers.starts_with("HTTP/1.1 404"), "{headers}");
    }

    #[test]
    fn it_serves_the_bytes_of_the_file_and_nothing_else() {
        let served = Served::start();
        let (headers, page) = get(&served.address, "/");
        let (missing, _) = get(&served.address, "/Cargo.toml");
        assert!(headers.starts_with("HTTP/1.1 200") && headers.contains("text/html"), "{headers}");
        assert_eq!(page, include_bytes!("../../../web/dist/federpendel.html"));
        assert!(missing.starts_with("HTTP/1.1 404"), "{missing}");
    }
}
