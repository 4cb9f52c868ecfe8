//! Requests: what each asks for, and the answer.

use std::convert::Infallible;
use std::net::IpAddr;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

use http_body_util::{BodyExt, Full};
use hyper::body::{Bytes, Incoming};
use hyper::header::{self, HeaderMap, HeaderValue};
use hyper::{Method, Request, Response, StatusCode};
use tokio::sync::Semaphore;
use tokio::task::spawn_blocking;
use tokio::time::timeout;

use super::{Asked, Limits, Patience, Trouble, outcome, overlay, page, radii, told};

/// What all requests share.
pub(super) struct Bench {
    limits: Limits,
    /// Only this machine is listened to.
    loopback: bool,
    workers: Arc<Semaphore>,
}

/// The work that a request asks for.
type Work = fn(&Asked, &Patience) -> Result<String, Trouble>;

const JSON: &str = "application/json";
/// A worker that does not look at its time is waited for so much longer.
const GRACE: Duration = Duration::from_secs(1);

/// Sent with every answer. The page loads nothing but its own files, and sends nothing but to its own server.
const HEADERS: [(&str, &str); 6] = [
    (
        "content-security-policy",
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; \
         base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    ),
    ("x-content-type-options", "nosniff"),
    ("referrer-policy", "no-referrer"),
    ("cross-origin-opener-policy", "same-origin"),
    ("cross-origin-resource-policy", "same-origin"),
    ("cache-control", "no-store"),
];

impl Bench {
    pub(super) fn new(limits: Limits, loopback: bool) -> Self {
        Bench { limits, loopback, workers: Arc::new(Semaphore::new(limits.workers)) }
    }
}

/// Answers a request.
pub(super) async fn answer(bench: Arc<Bench>, request: Request<Incoming>) -> Result<Response<Full<Bytes>>, Infallible> {
    let (status, kind, body) = match route(&bench, request).await {
        Ok((kind, body)) => (StatusCode::OK, kind, body),
        Err(trouble) => (trouble.status, JSON, Bytes::from(trouble.json())),
    };
    let mut response = Response::new(Full::new(body));
    *response.status_mut() = status;
    let headers = response.headers_mut();
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static(kind));
    for (name, value) in HEADERS {
        headers.insert(name, HeaderValue::from_static(value));
    }
    if status == StatusCode::METHOD_NOT_ALLOWED {
        headers.insert(header::ALLOW, HeaderValue::from_static("GET, HEAD, POST"));
    }
    Ok(response)
}

/// The type and the body of an answer.
async fn route(bench: &Bench, request: Request<Incoming>) -> Result<(&'static str, Bytes), Trouble> {
    if bench.loopback && !names_this_machine(request.headers()) {
        // A page of the network whose name was made to point here.
        let text = "this server answers to localhost and 127.0.0.1 only";
        return Err(Trouble { status: StatusCode::MISDIRECTED_REQUEST, text: text.to_owned() });
    }
    let path = request.uri().path().to_owned();
    let work: Option<Work> = match &*path {
        "/run" => Some(outcome::run),
        "/blocks" => Some(told::blocks),
        "/path" => Some(told::path),
        "/radii" => Some(radii::radii),
        "/request" => Some(overlay::request),
        _ => None,
    };
    match (request.method(), work) {
        (&Method::POST, Some(work)) => {
            let body = body(request, &bench.limits).await?;
            let text = compute(bench, body, work).await?;
            Ok((JSON, Bytes::from(text)))
        }
        (&Method::GET | &Method::HEAD, None) if path == "/rules.json" => {
            Ok((JSON, Bytes::from_static(page::rules().as_bytes())))
        }
        (&Method::GET | &Method::HEAD, None) => match page::file(&path) {
            Some((kind, text)) => Ok((kind, Bytes::from_static(text.as_bytes()))),
            None => Err(Trouble { status: StatusCode::NOT_FOUND, text: format!("there is nothing at {path}") }),
        },
        (method, _) => {
            let text = format!("{path} does not take {method}");
            Err(Trouble { status: StatusCode::METHOD_NOT_ALLOWED, text })
        }
    }
}

/// Whether a request's `Host` is a name of the machine itself. Only programs leave it out.
fn names_this_machine(headers: &HeaderMap) -> bool {
    let Some(host) = headers.get(header::HOST) else { return true };
    let Ok(host) = host.to_str() else { return false };
    let name = match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
        _ => host,
    };
    let address = name.trim_start_matches('[').trim_end_matches(']').parse::<IpAddr>();
    name.eq_ignore_ascii_case("localhost") || address.is_ok_and(|address| address.is_loopback())
}

/// A request's body. What lies beyond the limit is read and forgotten, as long as time allows: a client that is still
/// sending would not see the answer.
async fn body(request: Request<Incoming>, limits: &Limits) -> Result<Vec<u8>, Trouble> {
    let kind = request.headers().get(header::CONTENT_TYPE).and_then(|kind| kind.to_str().ok()).unwrap_or_default();
    if !kind.split(';').next().unwrap_or_default().trim().eq_ignore_ascii_case(JSON) {
        let text = format!("a request has the content type {JSON}");
        return Err(Trouble { status: StatusCode::UNSUPPORTED_MEDIA_TYPE, text });
    }
    let too_large = || Trouble::too_large(format!("a request has at most {} bytes", limits.body));
    let waits = request.headers().contains_key(header::EXPECT);
    let announced = request.headers().get(header::CONTENT_LENGTH).and_then(|length| length.to_str().ok()?.parse().ok());
    if waits && announced.is_some_and(|length: usize| length > limits.body) {
        return Err(too_large());
    }
    let (mut body, mut kept, mut over) = (request.into_body(), Vec::new(), false);
    let collected = timeout(limits.patience, async {
        while let Some(frame) = body.frame().await {
            let frame = frame.map_err(|error| Trouble::malformed(format!("the request breaks off: {error}")))?;
            let Ok(data) = frame.into_data() else { continue };
            over |= kept.len() + data.len() > limits.body;
            if over {
                kept = Vec::new();
            } else {
                kept.extend_from_slice(&data);
            }
        }
        Ok(())
    })
    .await;
    match collected {
        Ok(Err(trouble)) => Err(trouble),
        Ok(Ok(())) | Err(_) if over => Err(too_large()),
        Ok(Ok(())) => Ok(kept),
        Err(_) => {
            let seconds = limits.patience.as_secs();
            let text = format!("the request did not come within {seconds} s");
            Err(Trouble { status: StatusCode::REQUEST_TIMEOUT, text })
        }
    }
}

/// Has a worker do the work, as soon as one is free.
async fn compute(bench: &Bench, body: Vec<u8>, work: Work) -> Result<String, Trouble> {
    let limits = bench.limits;
    let permit = match timeout(limits.patience, Arc::clone(&bench.workers).acquire_owned()).await {
        Ok(Ok(permit)) => permit,
        _ => return Err(Trouble::too_long("the workbench is busy: ask again")),
    };
    let abandoned = Arc::new(AtomicBool::new(false));
    let patience = Patience::new(limits.computing, Arc::clone(&abandoned));
    let _watch = Watch(abandoned);
    let task = spawn_blocking(move || {
        // The permit is given back when the work is done, whether or not somebody still waits for it.
        let _permit = permit;
        work(&Asked::read(&body)?, &patience)
    });
    match timeout(limits.computing + GRACE, task).await {
        Ok(Ok(result)) => result,
        Ok(Err(_)) => Err(Trouble::own("the computation panicked")),
        Err(_) => {
            let seconds = limits.computing.as_secs();
            Err(Trouble::too_long(format!("the workbench computes for {seconds} s at most")))
        }
    }
}

/// Dropped with the request: the work is abandoned.
struct Watch(Arc<AtomicBool>);

impl Drop for Watch {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_of_this_machine_are_its_own() {
        let own = |host: &'static str| {
            names_this_machine(&HeaderMap::from_iter([(header::HOST, HeaderValue::from_static(host))]))
        };
        assert!(["localhost", "LOCALHOST:4044", "127.0.0.1:80", "[::1]:4044", "[::1]"].into_iter().all(own));
        assert!(
            !["example.com", "127.0.0.1.example.com:4044", "192.0.2.1", "localhost.example.com", ""]
                .into_iter()
                .any(own)
        );
    }
}
