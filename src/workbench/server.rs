//! Connections: who is let in, how long they stay, and how the server ends.

use std::io::{self, Write};
use std::net::{SocketAddr, TcpStream};
use std::pin::pin;
use std::sync::Arc;
use std::time::Duration;

use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper_util::rt::{TokioIo, TokioTimer};
use hyper_util::server::graceful::GracefulShutdown;
use tokio::net::TcpListener;
use tokio::runtime;
use tokio::sync::Semaphore;
use tokio::time::{sleep, timeout};

use super::Limits;
use super::route::{self, Bench};

/// The workbench's server, listening.
#[derive(Debug)]
pub struct Server {
    listener: std::net::TcpListener,
    limits: Limits,
}

/// How long open connections may go on when the server ends.
const FAREWELL: Duration = Duration::from_secs(5);
/// The stack of a worker, in bytes: as much as a main thread has.
const STACK: usize = 8 << 20;

impl Server {
    /// Listens at an address such as `127.0.0.1:4044`; port 0 is a free one.
    ///
    /// # Errors
    ///
    /// An address that is none, is not this machine's, or is taken.
    pub fn bind(address: &str, limits: Limits) -> io::Result<Server> {
        let listener = std::net::TcpListener::bind(address)?;
        listener.set_nonblocking(true)?;
        Ok(Server { listener, limits })
    }

    /// Where it listens.
    ///
    /// # Errors
    ///
    /// Those of the system.
    pub fn address(&self) -> io::Result<SocketAddr> {
        self.listener.local_addr()
    }

    /// Serves until Ctrl-C or the signal to terminate, and then until open requests are answered, for 5 s at most.
    ///
    /// # Errors
    ///
    /// A system that gives no threads, timers or signals.
    pub fn run(self) -> io::Result<()> {
        let runtime = runtime::Builder::new_current_thread()
            .enable_all()
            .max_blocking_threads(self.limits.workers)
            .thread_stack_size(STACK)
            .build()?;
        let result = runtime.block_on(self.accept());
        // A worker that still computes is not waited for.
        runtime.shutdown_background();
        result
    }

    async fn accept(self) -> io::Result<()> {
        let limits = self.limits;
        let bench = Arc::new(Bench::new(limits, self.address()?.ip().is_loopback()));
        let listener = TcpListener::from_std(self.listener)?;
        let (room, farewell) = (Arc::new(Semaphore::new(limits.connections)), GracefulShutdown::new());
        let mut stop = pin!(stopped()?);
        loop {
            // Nobody closes the semaphore.
            let Ok(place) = (tokio::select! {
                place = Arc::clone(&room).acquire_owned() => place,
                () = &mut stop => break,
            }) else {
                break;
            };
            let accepted = tokio::select! {
                accepted = listener.accept() => accepted,
                () = &mut stop => break,
            };
            let Ok((stream, _)) = accepted else {
                // Out of file descriptors, for instance: that passes.
                sleep(Duration::from_millis(50)).await;
                continue;
            };
            let spare = spare(&stream);
            let bench = Arc::clone(&bench);
            let service = service_fn(move |request| route::answer(Arc::clone(&bench), request));
            let connection = http1::Builder::new()
                .timer(TokioTimer::new())
                .header_read_timeout(limits.patience)
                .max_buf_size(limits.head)
                .serve_connection(TokioIo::new(stream), service);
            let connection = farewell.watch(connection);
            tokio::spawn(async move {
                if let Ok(Err(error)) = timeout(limits.connection, connection).await
                    && error.is_timeout()
                {
                    too_slow(spare);
                }
                drop(place);
            });
        }
        drop(listener);
        // Those that do not end by then are cut off.
        let _ = timeout(FAREWELL, farewell.shutdown()).await;
        Ok(())
    }
}

/// Another handle of a connection, for the last word on it.
fn spare(stream: &tokio::net::TcpStream) -> Option<TcpStream> {
    use std::os::fd::AsFd;
    stream.as_fd().try_clone_to_owned().ok().map(TcpStream::from)
}

/// Tells a client that its request's head did not come in time; whether it still listens, nobody knows.
fn too_slow(spare: Option<TcpStream>) {
    const ANSWER: &[u8] = b"HTTP/1.1 408 Request Timeout\r\ncontent-type: application/json\r\nconnection: close\r\n\
        content-length: 44\r\n\r\n{\"error\": \"the request did not come in time\"}";
    if let Some(mut stream) = spare {
        let _ = stream.write_all(ANSWER);
    }
}

/// Ends with Ctrl-C or the signal to terminate.
fn stopped() -> io::Result<impl Future<Output = ()>> {
    use tokio::signal::unix::{SignalKind, signal};
    let (mut interrupt, mut terminate) = (signal(SignalKind::interrupt())?, signal(SignalKind::terminate())?);
    Ok(async move {
        tokio::select! {
            _ = interrupt.recv() => {}
            _ = terminate.recv() => {}
        }
    })
}
