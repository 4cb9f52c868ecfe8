//! Requests that are too large, too slow, too many or nonsense: a clear answer each, and the server goes on.

use std::io::Write;
use std::thread;
use std::time::{Duration, Instant};

use serde_json::json;

use crate::server::{Server, answer, request};

#[test]
fn the_page_and_its_files_come_with_a_strict_policy() {
    let server = Server::start(&[]);
    for path in [
        "/",
        "/workbench.js",
        "/drawing.js",
        "/story.js",
        "/editor.js",
        "/link.js",
        "/workbench.css",
        "/drawing.css",
        "/icon.svg",
        "/rules.json",
    ] {
        let answer = server.get(path);
        assert_eq!(answer.status, 200, "{path}");
        assert!(
            answer.head.contains("content-security-policy: default-src 'none'; script-src 'self'"),
            "{}",
            answer.head
        );
        assert!(answer.head.contains("x-content-type-options: nosniff"), "{}", answer.head);
        // Nothing is loaded from elsewhere: the only addresses are names of XML.
        let body = answer.body.replace("http://www.w3.org/2000/svg", "");
        assert!(!body.contains("http://") && !body.contains("https://") && !body.contains("url(//"), "{path}");
    }
    let rules = server.get("/rules.json").json();
    assert_eq!(rules["profiles"].as_array().unwrap().len(), radcomp_spec::profile::BUILTIN.len());
    assert_eq!(rules["clauses"].as_object().unwrap().len(), radcomp_spec::clause::ALL.len());
}

#[test]
fn wrong_requests_are_told_what_is_wrong() {
    let server = Server::start(&[]);
    let missing = server.get("/no-such-page");
    assert_eq!((missing.status, &*missing.error()), (404, "there is nothing at /no-such-page"));
    let method = server.get("/run");
    assert_eq!((method.status, &*method.error()), (405, "/run does not take GET"));
    let profile = server.post("/run", br#"{"program": "G01 X5", "profile": "seed-mil"}"#);
    assert_eq!((profile.status, &*profile.error()), (422, "there is no profile named \"seed-mil\""));
    let table = server.post("/run", br#"{"program": "", "profile": "seed-mill", "tools": "[[tool]]\nnumber = 0"}"#);
    assert!(table.status == 422 && table.error().contains("tool table:2:10"), "{table:?}");
    let unknown = server.post("/run", br#"{"programme": ""}"#);
    assert!(unknown.status == 400 && unknown.error().contains("unknown field `programme`"), "{unknown:?}");

    // A page elsewhere whose name points at this machine, and one that sends a form.
    let mut stream = server.connect();
    stream.write_all(b"GET / HTTP/1.1\r\nHost: example.com\r\nConnection: close\r\n\r\n").unwrap();
    assert_eq!(answer(stream).status, 421);
    let mut stream = server.connect();
    let form = server.head("/run", 2).replace("application/json", "text/plain");
    write!(stream, "{form}{{}}").unwrap();
    assert_eq!(answer(stream).status, 415);
    let mut stream = server.connect();
    stream.write_all(b"\x16\x03\x01 this is no HTTP\r\n\r\n").unwrap();
    assert_eq!(answer(stream).status, 400);
    let mut stream = server.connect();
    let _ = write!(stream, "GET / HTTP/1.1\r\nHost: localhost\r\nX-Long: {}\r\n\r\n", "a".repeat(100_000));
    assert_eq!(answer(stream).status, 431);
    server.goes_on();
}

#[test]
fn a_request_of_100_megabytes_is_refused() {
    let server = Server::start(&[]);
    let large = server.post("/run", &vec![b' '; 100_000_000]);
    assert_eq!((large.status, &*large.error()), (413, "a request has at most 4194304 bytes"));

    // The same without a length, in pieces.
    let mut stream = server.connect();
    let head = server.head("/run", 0).replace("Content-Length: 0", "Transfer-Encoding: chunked");
    stream.write_all(head.as_bytes()).unwrap();
    let piece = [b"100000\r\n", &*vec![b' '; 0x10_0000], b"\r\n"].concat();
    for _ in 0..100 {
        stream.write_all(&piece).unwrap();
    }
    stream.write_all(b"0\r\n\r\n").unwrap();
    assert_eq!(answer(stream).status, 413);

    // Who asks before sending is told at once.
    let mut stream = server.connect();
    let head = server.head("/run", 100_000_000).replace("\r\n\r\n", "\r\nExpect: 100-continue\r\n\r\n");
    stream.write_all(head.as_bytes()).unwrap();
    assert_eq!(answer(stream).status, 413);
    server.goes_on();
}

#[test]
fn a_program_of_a_million_blocks_is_refused() {
    let server = Server::start(&[]);
    let program: String = (0..1_000_000).map(|number| ["X1\n", "X2\n"][number % 2]).collect();
    let answer = server.post("/run", request(&format!("G01\n{program}")).as_bytes());
    let words = "a program in the workbench has at most 10000 blocks; `radcomp run` has no limit";
    assert_eq!((answer.status, &*answer.error()), (413, words));
    server.goes_on();
}

#[test]
fn a_program_of_as_many_blocks_as_there_may_be_is_run() {
    let server = Server::start(&["--time-limit", "120"]);
    let program: String = (0..9_998).map(|number| format!("X{number}.5 Y{}\n", number % 7)).collect();
    let answer = server.post("/run", request(&format!("G41 D1 G01 X0 Y0\n{program}G40 X-50 Y-50\n")).as_bytes());
    assert_eq!(answer.status, 200, "{}", &answer.body[..answer.body.len().min(300)]);
    assert_eq!(answer.json()["blocks"].as_array().unwrap().len(), 10_000);
}

#[test]
fn bytes_that_are_no_text_are_refused() {
    let server = Server::start(&[]);
    let answer = server.post("/run", b"{\"program\": \"G01 X\xff\xfe\"}");
    let words = "the request is not text: byte 18, counted from 0, is not UTF-8";
    assert_eq!((answer.status, &*answer.error()), (400, words));
    let noise: Vec<u8> = (0..100_000_u32).map(|number| (number.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    assert_eq!(server.post("/run", &noise).status, 400);
    // Text that is no program is a program with a fault, at its place.
    let program = server.post("/run", request("G01 X5\nN20 Y\u{1f600}\n").as_bytes());
    assert_eq!(program.status, 200);
    let refused = &program.json()["refused"];
    assert_eq!((&refused["line"], &refused["column"]), (&2.into(), &5.into()), "{refused}");
    server.goes_on();
}

#[test]
fn slow_clients_are_cut_off_and_hold_nobody_up() {
    let server = Server::start(&["--time-limit", "2"]);
    // Half a head, half a body, and a client that says nothing at all.
    let mut half_a_head = server.connect();
    half_a_head.write_all(b"POST /run HTTP/1.1\r\nHost: localhost\r\nContent-").unwrap();
    let mut half_a_body = server.connect();
    half_a_body.write_all((server.head("/run", 1000) + "{\"program\":").as_bytes()).unwrap();
    let silent: Vec<_> = (0..50).map(|_| server.connect()).collect();
    let begun = Instant::now();
    server.goes_on();
    // One byte at a time does not help.
    let mut dripping = half_a_body.try_clone().unwrap();
    let drip = thread::spawn(move || {
        while begun.elapsed() < Duration::from_secs(20) && dripping.write_all(b" ").is_ok() {
            thread::sleep(Duration::from_millis(100));
        }
        begun.elapsed()
    });
    let head = answer(half_a_head);
    assert_eq!((head.status, &*head.error()), (408, "the request did not come in time"));
    let body = answer(half_a_body);
    assert_eq!((body.status, &*body.error()), (408, "the request did not come within 2 s"));
    assert!(drip.join().unwrap() < Duration::from_secs(20));
    drop(silent);
    server.goes_on();
}

#[test]
fn a_hundred_clients_at_once_are_all_answered() {
    let server = Server::start(&["--time-limit", "60"]);
    let program: String = (0..60).map(|number| format!("X{} Y{}\n", number * 20, 20 * (number % 2))).collect();
    let body = request(&format!("G41 D1 G01 X0 Y0\n{program}"));
    let first = server.post("/run", body.as_bytes()).json();
    thread::scope(|scope| {
        let ask = || server.post("/run", body.as_bytes());
        let clients: Vec<_> = (0..100).map(|_| scope.spawn(ask)).collect();
        for client in clients {
            let answer = client.join().unwrap();
            assert_eq!(answer.status, 200, "{answer:?}");
            assert_eq!(answer.json()["path"], first["path"]);
        }
    });
    server.goes_on();
}

#[test]
fn work_that_nobody_waits_for_is_given_up_and_work_beyond_its_time_is_told() {
    let server = Server::start(&["--time-limit", "1"]);
    // Exact closed forms of ten thousand corners of arcs whose centres are roots take far longer than a second.
    let arc = |number: usize| format!("G02 X{}.1 Y0.{:03} R50.3\n", number * 3, number * 370 % 997);
    let program = format!("G41 D1 G01 X1 Y1\n{}", (1..9_990).map(arc).collect::<String>());
    let request = json!({ "program": program, "profile": "seed-mill", "offset": 1, "radius": "0.25" }).to_string();
    let answer = server.post("/path", request.as_bytes());
    assert_eq!(answer.status, 503, "{}", &answer.body[..answer.body.len().min(300)]);
    assert!(answer.error().contains("1 s at most"), "{}", answer.error());
    // Clients that leave free their workers.
    for _ in 0..20 {
        let mut stream = server.connect();
        stream.write_all((server.head("/path", request.len()) + &request).as_bytes()).unwrap();
        drop(stream);
    }
    let begun = Instant::now();
    while server.post("/run", crate::server::request("G01 X1").as_bytes()).status != 200 {
        assert!(begun.elapsed() < Duration::from_secs(30));
    }
    server.goes_on();
}

#[test]
fn it_ends_when_it_is_told_to() {
    let mut server = Server::start(&[]);
    server.goes_on();
    let idle = server.connect();
    let interrupt = std::process::Command::new("kill").args(["-INT", &server.child.id().to_string()]).status().unwrap();
    assert!(interrupt.success());
    let begun = Instant::now();
    let status = loop {
        if let Some(status) = server.child.try_wait().unwrap() {
            break status;
        }
        assert!(begun.elapsed() < Duration::from_secs(20), "it goes on after Ctrl-C");
        thread::sleep(Duration::from_millis(20));
    };
    assert!(status.success(), "{status}");
    drop(idle);
}

#[test]
fn an_address_that_is_taken_is_told() {
    let server = Server::start(&[]);
    let output = std::process::Command::new(crate::server::RADCOMP)
        .args(["serve", "--listen", &server.address])
        .output()
        .unwrap();
    let complaint = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(2));
    assert!(complaint.contains("cannot be listened at") && complaint.contains("--listen"), "{complaint}");
}
