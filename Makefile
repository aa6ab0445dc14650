# The main commands are `make bringup` and `make test`. Each installs missing
# packages (apt), builds and runs. The commands are scripts in scripts/.

.PHONY: help install build bringup test bench figures lint clean fuzz second_opinion kill_rounds sanitize colcon

help:
	@echo 'make bringup   install, build and run the default mission; launch arguments'
	@echo '               in ARGS, e.g. make bringup ARGS="mission:=gulf once:=true rviz:=false"'
	@echo 'make test      install, build, run every test; last line: N passed, N failed'
	@echo 'make build     build into build/ and devel/ (BUILD_TYPE=Debug, JOBS=1, PLAIN=1)'
	@echo 'make colcon    build with colcon into build/colcon/'
	@echo 'make install   install the Debian packages of apt-packages.txt'
	@echo 'make bench     run the benchmark programs'
	@echo 'make figures   make the pictures of README and docs'
	@echo 'make fuzz      fuzz Turtle, WKT, SPARQL and policies (SECONDS=600 each)'
	@echo 'make second_opinion  random queries against rdflib and Oxigraph (CASES=10000)'
	@echo 'make kill_rounds  SIGKILL the KG node at random moments (ROUNDS=500)'
	@echo 'make sanitize  the C++ tests under AddressSanitizer and UBSan'
	@echo 'make lint      clang-format, catkin_lint and clang-tidy'
	@echo 'make clean     remove all that was built or written: build, devel, install, state'

install:
	@scripts/install_packages.sh base checks gui

build:
	@scripts/install_packages.sh base
	@scripts/build.sh

colcon:
	@scripts/colcon.sh $(ARGS)

bringup:
	@scripts/bringup.sh $(ARGS)

test:
	@scripts/test.sh

bench:
	@scripts/bench.sh $(ARGS)

figures:
	@scripts/figures.sh

lint:
	@scripts/lint.sh $(ARGS)

fuzz:
	@scripts/fuzz.sh $(or $(SECONDS),600)

second_opinion:
	@scripts/second_opinion.sh $(or $(CASES),10000)

kill_rounds:
	@scripts/kill_rounds.sh $(or $(ROUNDS),500)

sanitize:
	@scripts/sanitize.sh

clean:
	@scripts/clean.sh
