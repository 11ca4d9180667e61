# Moves an arm of two joints and says everything again every 2 s.
# python3 sender.py 127.0.0.1 19960 [CYCLES]
import itertools, socket, sys, time

class Source:
    def __init__(self, name, to, restate=2.0):
        self.name = f"{name}@{time.time_ns():x}"  # RUN: another one at each start
        self.to, self.restate = to, restate
        self.out = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.state, self.changed = {}, {}  # line without its values: values
        self.sequence = self.restatements = 0
        self.next_restatement = time.monotonic() + restate

    def say(self, statement, *values):
        text = " ".join(f"{v:.9f}".rstrip("0").rstrip(".") if isinstance(v, float) else v for v in values)
        if self.state.get(statement) != text:
            self.state[statement] = self.changed[statement] = text

    def flush(self):
        if self.changed:
            self.send(self.changed, "")
            self.changed = {}
        if time.monotonic() >= self.next_restatement:  # here all of it fits one datagram
            self.restatements += 1
            self.send(self.state, f" restated part=r{self.restatements}:1/1")
            self.next_restatement += self.restate

    def send(self, lines, words):
        text = f"RK1 {self.name} {self.sequence} {time.time():.6f}{words}\n"
        text += "".join(f"{statement} {values}\n" for statement, values in lines.items())
        self.out.sendto(text.encode(), self.to)
        self.sequence += 1

source = Source("sim", (sys.argv[1], int(sys.argv[2])))
for i in range(int(sys.argv[3])) if len(sys.argv) > 3 else itertools.count():
    source.say("order arm", "shoulder", "elbow")  # before the joints that it names
    source.say("joints arm", 0.004 * (i % 200), 0.006 * (i % 200))
    source.flush()
    time.sleep(0.01)
