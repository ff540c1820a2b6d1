"""edit-seams --serve, as tests of it need it."""
import contextlib
import http.client
import pathlib
import resource
import signal
import socket
import subprocess
import tempfile
import time


def slow_to_sew(pattern, copies=6):
    """The pattern with its panels several times over: find-seams takes a while."""
    panels = pattern["pattern"]["panels"]
    order = list(panels)
    for copy in range(copies):
        for name in order:
            panels[f"{name}_copy{copy}"] = panels[name]
    pattern["pattern"]["panel_order"] = list(panels)
    return pattern


def expect(holds, what):
    if not holds:
        raise AssertionError(what)


class Server:
    """edit-seams --serve, and its address."""

    def __init__(self, tools, folder, pattern, *words, files=None, old=None):
        self.output = folder / "sewn.json"
        if old:
            self.output.write_text(old)
        def limit():
            if files:
                resource.setrlimit(resource.RLIMIT_NOFILE, (files, files))
        self.process = subprocess.Popen(
            [tools / "edit-seams", pattern, "--serve", "-o", self.output, "-q",
             *map(str, words)], stderr=subprocess.PIPE, text=True, preexec_fn=limit)
        for line in self.process.stderr:
            if "http://" in line:
                break
        whole = next(word for word in line.split() if word.startswith("http://"))
        self.host, _, path = whole[len("http://"):].partition("/")
        self.address = whole
        self.port, self.path = int(self.host.split(":")[1]), "/" + path

    def ask(self, method, path, body=None, host=None, seconds=20):
        """Status and body of the answer."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=seconds)
        connection.request(method, path, body, {"Host": host or self.host})
        answer = connection.getresponse()
        return answer.status, answer.read().decode()

    def connect(self):
        return socket.create_connection(("127.0.0.1", self.port), timeout=20)

    def processor_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / 100

    def end(self, by=signal.SIGTERM):
        """Seconds until it has ended."""
        start = time.monotonic()
        self.process.send_signal(by)
        expect(self.process.wait(20) == 0, f"{by} does not end it well")
        return time.monotonic() - start


@contextlib.contextmanager
def serving_of(tools, *words, **options):
    with tempfile.TemporaryDirectory() as name:
        server = Server(tools, pathlib.Path(name), *words, **options)
        try:
            yield server
        finally:
            if server.process.poll() is None:
                server.end()
