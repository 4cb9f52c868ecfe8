//! A server of the tests' own, and requests over plain sockets.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::Value;

/// The command that cargo built for these tests.
pub const RADCOMP: &str = env!("CARGO_BIN_EXE_radcomp");

/// `radcomp serve` at a free port; it ends with the value.
pub struct Server {
    pub child: Child,
    /// Address and port.
    pub address: String,
}

/// An answer.
#[derive(Debug)]
pub struct Answer {
    pub status: u16,
    pub head: String,
    pub body: String,
}

impl Server {
    pub fn start(options: &[&str]) -> Server {
        let mut child = Command::new(RADCOMP)
            .args(["serve", "--listen", "127.0.0.1:0"])
            .args(options)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.split_once("http://").and_then(|(_, rest)| rest.split_once('/')).expect(&line).0;
        Server { child, address: address.to_owned() }
    }

    pub fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(&self.address).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream
    }

    pub fn get(&self, path: &str) -> Answer {
        let mut stream = self.connect();
        write!(stream, "GET {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n", self.address).unwrap();
        answer(stream)
    }

    /// Sends a body as JSON; how much of it the server takes is its own affair.
    pub fn post(&self, path: &str, body: &[u8]) -> Answer {
        let mut stream = self.connect();
        let _ = stream.write_all(self.head(path, body.len()).as_bytes()).and_then(|()| stream.write_all(body));
        answer(stream)
    }

    pub fn head(&self, path: &str, length: usize) -> String {
        format!(
            "POST {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\nContent-Type: application/json\r\n\
             Content-Length: {length}\r\n\r\n",
            self.address
        )
    }

    /// It answers as it should, whatever happened before.
    pub fn goes_on(&self) {
        let answer = self.post("/run", request("G41 D1 G01 X10 Y0\nX20\n").as_bytes());
        assert_eq!(answer.status, 200, "{answer:?}");
        assert_eq!(answer.json()["path"][0]["shape"]["to"], serde_json::json!([10.0, 5.0]));
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Answer {
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.body).expect(&self.body)
    }

    /// What is wrong, in the server's words.
    pub fn error(&self) -> String {
        self.json()["error"].as_str().unwrap_or_else(|| panic!("no error: {self:?}")).to_owned()
    }
}

/// A program for a tool of radius 5 on `seed-mill`.
pub fn request(program: &str) -> String {
    serde_json::json!({ "program": program, "profile": "seed-mill", "offset": 1, "radius": "5" }).to_string()
}

/// Reads an answer to the end of its connection.
pub fn answer(mut stream: TcpStream) -> Answer {
    let mut bytes = Vec::new();
    let ending = stream.read_to_end(&mut bytes);
    let text = String::from_utf8_lossy(&bytes).into_owned();
    let (head, body) = text.split_once("\r\n\r\n").unwrap_or_else(|| panic!("no answer: {ending:?}, {text:?}"));
    let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).expect(head);
    Answer { status, head: head.to_owned(), body: body.to_owned() }
}
